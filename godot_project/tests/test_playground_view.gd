extends "res://tests/framework/test_case.gd"
## The playground's view without a window: picking, drags and clicks.

const PlaygroundDocument := preload(
	"res://addons/ga_godot/playground/document/playground_document.gd"
)
const EntryEdits := preload("res://addons/ga_godot/playground/document/entry_edits.gd")
const EntryList := preload("res://addons/ga_godot/playground/entries/entry_list.gd")
const OwnHistory := preload("res://addons/ga_godot/playground/document/own_history.gd")
const SceneDrawing := preload("res://addons/ga_godot/playground/view/scene_drawing.gd")
const ViewHandle := preload("res://addons/ga_godot/playground/view/view_handle.gd")
const ViewPointer := preload("res://addons/ga_godot/playground/view/view_pointer.gd")

const SIZE := Vector2i(800, 600)

var _history := OwnHistory.new()
var _document := PlaygroundDocument.new(_history)
var _edits := EntryEdits.new(_document)
var _list := EntryList.new(_document, _edits)
var _viewport := SubViewport.new()
var _camera := Camera3D.new()
var _drawing := SceneDrawing.new()
var _pointer: ViewPointer


func test_a_click_selects() -> void:
	_set_up()
	_show({"A": "point(1, 0, 0)", "s": "sphere(point(-2, 0, 0), 1)", "p": "plane(e2, -1)"})
	expect_true(_click(_at(Vector3(1, 0, 0))), "a point takes the click")
	expect_equal(_list.selection, PackedStringArray(["A"]), "selection")
	expect_true(_click(_at(Vector3(-2, 0.5, 0)), true), "a sphere takes the click")
	expect_equal(_list.selection, PackedStringArray(["A", "s"]), "selection with Ctrl")
	expect_true(_click(_at(Vector3(1, 0, 0)), true), "again")
	expect_equal(
		_list.selection, PackedStringArray(["s"]), "selection with Ctrl on what is selected"
	)
	expect_true(_click(_at(Vector3(3, -1, 0))), "a plane takes what is left")
	expect_equal(_list.selection, PackedStringArray(["p"]), "selection")
	expect_equal(_history.has_undo(), false, "steps in the history")


func test_a_click_on_empty_space() -> void:
	_set_up()
	_show({"A": "point(1, 0, 0)", "p": "plane(e2, -1)"})
	_list.select(["A"])
	_pointer.picks_faces = false
	expect_equal(_click(_at(Vector3(3, -1, 0))), false, "a plane, which is everywhere")
	expect_equal(_list.selection, PackedStringArray(), "selection")
	_list.select(["A"])
	_pointer.clears_selection = false
	expect_equal(_click(_at(Vector3(3, -1, 0))), false, "a click that is not taken")
	expect_equal(_list.selection, PackedStringArray(["A"]), "selection")


func test_dragging_a_point_is_one_action() -> void:
	_set_up()
	_show({"A": "point(1, 0, 0)", "s": "sphere(A, 1)"})
	var followed: Array[Vector3] = []
	var scene := _document.scene
	_document.changed.connect(
		func() -> void: followed.append(scene.get_value("s").classify().center as Vector3)
	)
	_drag(_at(Vector3(1, 0, 0)), _at(Vector3(2, 1, 0)))
	expect_true(followed.size() > 4, "changes while dragging")
	var position: Vector3 = _document.scene.get_parameters("A").position
	expect_near(
		_camera.unproject_position(position).distance_to(_at(Vector3(2, 1, 0))),
		0.0,
		1.0,
		"distance in pixels"
	)
	expect_vector_near(followed[-1], position, 1e-5)
	expect_true(
		_document.scene.get_expression("A").length() < 30,
		"an expression without needless digits: %s" % _document.scene.get_expression("A")
	)
	_history.undo()
	expect_equal(_document.scene.get_expression("A"), "point(1, 0, 0)", "expression after undo")
	expect_equal(_history.has_undo(), false, "more steps")


func test_handles_away_from_the_object() -> void:
	_set_up()
	_show({"c": "circle(0, e2, 1)", "A": "point(0, 0, 0)"})
	_list.select(["c"])
	var normal := _handle("c", "normal")
	expect_near(normal.position.distance_to(normal.stem), 60.0, 15.0, "length of the arm in pixels")
	var tip: Vector3 = normal.handle["position"]
	_drag(normal.position, _at(Vector3(0, 0, tip.length())), true)
	expect_equal(
		_document.scene.get_expression("c"), "circle(0, e3, 1)", "circle with another normal"
	)
	_drag(_handle("c", "radius").position, _at(Vector3(2.02, 0, 0)), true)
	expect_equal(
		_document.scene.get_expression("c"), "circle(0, e3, 2)", "circle with another radius"
	)


func test_ctrl_snaps_and_shift_keeps_the_height() -> void:
	_set_up()
	_show({"A": "point(1, 0.5, 0)"})
	_drag(_at(Vector3(1, 0.5, 0)), _at(Vector3(2.03, 0.5, 1.02)), true, true)
	expect_equal(_document.scene.get_expression("A"), "point(2, 0.5, 1)", "expression")


func test_escape_and_the_right_button_cancel_a_drag() -> void:
	_set_up()
	_show({"A": "point(1, 0, 0)"})
	for how: InputEvent in [_key(KEY_ESCAPE), _button(MOUSE_BUTTON_RIGHT, true, Vector2.ZERO)]:
		_send(_button(MOUSE_BUTTON_LEFT, true, _at(Vector3(1, 0, 0))))
		_send(_motion(_at(Vector3(2, 1, 0)), MOUSE_BUTTON_MASK_LEFT))
		expect_true(_document.scene.get_expression("A") != "point(1, 0, 0)", "dragging")
		expect_true(_send(how), "it is taken")
		expect_equal(_document.scene.get_expression("A"), "point(1, 0, 0)", "expression")
		expect_equal(
			_send(_motion(_at(Vector3(3, 1, 0)), MOUSE_BUTTON_MASK_LEFT)),
			false,
			"the mouse afterwards"
		)
		_send(_button(MOUSE_BUTTON_LEFT, false, _at(Vector3(3, 1, 0))))
		expect_equal(_document.scene.get_expression("A"), "point(1, 0, 0)", "expression afterwards")
	expect_equal(_history.has_undo(), false, "steps in the history")
	expect_equal(_send(_key(KEY_ESCAPE)), false, "Escape without a drag")


func test_an_object_is_dragged_by_the_grabbed_point() -> void:
	_set_up()
	_show({"s": "sphere(point(0, 0, 0), 2)", "x": "sphere(s, 2)"})
	var grabbed := Vector3(0.9, 1.2, sqrt(4.0 - 0.81 - 1.44))
	_drag(_at(grabbed), _at(grabbed) + Vector2(60, 0))
	var center: Vector3 = _document.scene.get_parameters("s").center
	expect_true(center.x > 0.5, "the sphere moved to %s" % center)
	expect_near(
		_camera.unproject_position(center + grabbed).distance_to(_at(grabbed) + Vector2(60, 0)),
		0.0,
		2.0,
		"what was grabbed, in pixels from the mouse"
	)


func test_a_point_of_an_object_through_points() -> void:
	_set_up()
	_show({"q": "point_pair(point(-2, 0, 0), point(2, 0, 0))"})
	_drag(_at(Vector3(2, 0, 0)), _at(Vector3(2, 0, 0)) + Vector2(0, -50))
	var parameters := _document.scene.get_parameters("q")
	expect_equal(parameters.a, Vector3(-2, 0, 0), "the other point")
	expect_near(
		_camera.unproject_position(parameters.b as Vector3).distance_to(
			_at(Vector3(2, 0, 0)) + Vector2(0, -50)
		),
		0.0,
		1.5,
		"distance in pixels"
	)


func test_computed_objects_are_selected_but_not_dragged() -> void:
	_set_up()
	_show(
		{
			"A": "point(-3, 0, 0)",
			"B": "point(3, 0, 0)",
			"m": "meet(plane(e1, 0), join(A, B) ^ einf)"
		}
	)
	var before := _document.scene.document
	_drag(_at(Vector3.ZERO), _at(Vector3(1, 1, 0)))
	expect_equal(_list.selection, PackedStringArray(["m"]), "selection")
	expect_equal(_document.scene.document, before, "document")


func test_a_click_adds_on_the_ground_and_on_surfaces() -> void:
	_set_up()
	_pointer.adding = &"point"
	expect_true(_click(_at(Vector3(1.02, 0, 2.01)), true), "adding on the ground")
	expect_equal(_document.scene.get_expression("A"), "point(1, 0, 2)", "expression")
	expect_equal(_list.selection, PackedStringArray(["A"]), "selection")
	_show({"s": "sphere(point(0, 0, 0), 2)"})
	_pointer.adding = &"plane"
	_click(_at(Vector3(0, 2, 0)))
	var plane := _document.scene.get_value("p1").classify()
	expect_vector_near(plane.normal as Vector3, Vector3.UP, 0.02)
	expect_near(plane.distance as float, 2.0, 0.01, "distance")
	_history.undo()
	expect_equal(_document.scene.get_names(), PackedStringArray(["s"]), "entries after undo")
	expect_true(_send(_key(KEY_ESCAPE)), "Escape ends it")
	expect_equal(_pointer.adding, &"", "mode")


func test_every_kind_can_be_added_anywhere() -> void:
	_set_up()
	for point: Vector2 in [_at(Vector3(1, 0, 1)), Vector2(400, 2), Vector2(2, 300)]:
		for kind: StringName in EntryEdits.NewObjects.KINDS:
			_pointer.adding = kind
			var before := _document.scene.get_entry_count()
			_click(point)
			expect_equal(
				_document.scene.get_entry_count(), before + 1, "entries after adding %s" % kind
			)
			var entry := _document.scene.get_names()[before]
			expect_equal(
				_document.scene.get_error(entry),
				"",
				"error of %s = %s" % [entry, _document.scene.get_expression(entry)]
			)


func test_a_double_click_adds_on_empty_space() -> void:
	_set_up()
	_pointer.double_click_adds = &"point"
	var event := _button(MOUSE_BUTTON_LEFT, true, _at(Vector3(1, 0, 1)))
	event.double_click = true
	expect_true(_send(event), "it is taken")
	expect_equal(_document.scene.get_names(), PackedStringArray(["A"]), "entries")


func test_an_entry_that_is_removed_during_its_drag() -> void:
	_set_up()
	_show({"A": "point(1, 0, 0)"})
	_send(_motion(_at(Vector3(1, 0, 0)), 0))
	_send(_button(MOUSE_BUTTON_LEFT, true, _at(Vector3(1, 0, 0))))
	_send(_motion(_at(Vector3(2, 1, 0)), MOUSE_BUTTON_MASK_LEFT))
	_document.scene.remove_entry("A")
	_send(_motion(_at(Vector3(3, 1, 0)), MOUSE_BUTTON_MASK_LEFT))
	_send(_button(MOUSE_BUTTON_LEFT, false, _at(Vector3(3, 1, 0))))
	_document.show_scene(GAScene.new(), "")
	_send(_motion(_at(Vector3(1, 0, 0)), 0))
	expect_equal(_pointer.is_dragging(), false, "dragging")


func test_a_node_with_another_transform() -> void:
	_set_up()
	_show({"A": "point(1, 0, 0)"})
	_drawing.visible = false
	var node := GANode3D.new()
	node.scene = _document.scene
	node.entry = &"A"
	node.transform = Transform3D(
		Basis(Vector3.UP, PI / 2.0).scaled(Vector3.ONE * 2.0), Vector3(0, 1, 0)
	)
	_viewport.add_child(node)
	_pointer.other_nodes = [node]
	var place := node.to_global(Vector3(1, 0, 0))
	var target := node.to_global(Vector3(1, 0.5, 1))
	_drag(_at(place), _at(target))
	var position: Vector3 = _document.scene.get_parameters("A").position
	expect_near(
		_camera.unproject_position(node.to_global(position)).distance_to(_at(target)),
		0.0,
		1.0,
		"distance in pixels"
	)
	node.free()
	expect_equal(_send(_motion(_at(place), 0)), false, "the mouse where it was")


func test_an_orthogonal_view() -> void:
	_set_up()
	_camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	_camera.size = 10.0
	_show({"A": "point(1, 0, 0)"})
	_drag(_at(Vector3(1, 0, 0)), _at(Vector3(-2, 1, 3)))
	var position: Vector3 = _document.scene.get_parameters("A").position
	expect_near(
		_camera.unproject_position(position).distance_to(_at(Vector3(-2, 1, 3))),
		0.0,
		1.0,
		"distance in pixels"
	)


func _set_up() -> void:
	_viewport.size = SIZE
	_viewport.own_world_3d = true
	add_node(_viewport)
	for node: Node in [_camera, _drawing, _list]:
		_viewport.add_child(node)
	_camera.look_at_from_position(Vector3(0, 4, 10), Vector3.ZERO)
	_pointer = ViewPointer.new(_drawing, _document, _edits, _list)


## Clears the history, whose actions hold references to the scene.
func free_nodes() -> void:
	super()
	_history.clear()


func _show(entries: Dictionary[String, String]) -> void:
	var scene := GAScene.new()
	for entry in entries:
		scene.add_entry(entry, entries[entry])
	_document.show_scene(scene, "")
	_history.clear()


func _handle(entry: String, key: String) -> ViewHandle:
	for handle: ViewHandle in _pointer.get_handles(_camera):
		if String(handle.node.entry) == entry and handle.key() == key:
			return handle
	return null


func _at(place: Vector3) -> Vector2:
	return _camera.unproject_position(place)


func _click(point: Vector2, with_control := false) -> bool:
	var press := _button(MOUSE_BUTTON_LEFT, true, point)
	press.ctrl_pressed = with_control
	var was_used := _send(press)
	_send(_button(MOUSE_BUTTON_LEFT, false, point))
	return was_used


func _drag(from: Vector2, to: Vector2, with_control := false, with_shift := false) -> void:
	_send(_motion(from, 0))
	_send(_button(MOUSE_BUTTON_LEFT, true, from))
	for step in 8:
		var motion := _motion(from.lerp(to, (step + 1) / 8.0), MOUSE_BUTTON_MASK_LEFT)
		motion.ctrl_pressed = with_control
		motion.shift_pressed = with_shift
		expect_true(_send(motion), "the motion is taken")
	_send(_button(MOUSE_BUTTON_LEFT, false, to))


func _send(event: InputEvent) -> bool:
	return _pointer.handle_input(event, _camera)


func _button(index: MouseButton, pressed: bool, point: Vector2) -> InputEventMouseButton:
	var event := InputEventMouseButton.new()
	event.button_index = index
	event.pressed = pressed
	event.position = point
	return event


func _motion(point: Vector2, buttons: int) -> InputEventMouseMotion:
	var event := InputEventMouseMotion.new()
	event.position = point
	event.button_mask = buttons as MouseButtonMask
	return event


func _key(code: Key) -> InputEventKey:
	var event := InputEventKey.new()
	event.keycode = code
	event.pressed = true
	return event
