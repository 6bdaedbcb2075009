extends "res://tests/framework/test_case.gd"
## The playground in a running game, used by mouse and keyboard.

const DragField := preload("res://addons/ga_godot/playground/drag_field.gd")
const EntryRow := preload("res://addons/ga_godot/playground/entry_row.gd")
const Hands := preload("res://tests/framework/hands.gd")
const NumberField := preload("res://addons/ga_godot/playground/number_field.gd")
const Playground := preload("res://demos/playground/playground.gd")
const PlaygroundTheme := preload("res://addons/ga_godot/playground/playground_theme.gd")
const ViewPoint := preload("res://addons/ga_godot/playground/view_point.gd")

const STATE := "user://test_playground.cfg"
const SAVED := "user://test_playground.json"

var _demo: Playground


func test_buttons_add_objects_and_undo_takes_them_back() -> void:
	await _open_empty()
	Hands.click(_part("Objects/point"))
	Hands.click(_part("Objects/point"))
	expect_equal(_names(), ["A", "B"], "two points")
	expect_equal(_scene().get_expression("B"), "point(1, 0, 0)", "place of the second")
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	expect_equal(_names(), ["A"], "after undo")
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	expect_equal(_names(), ["A", "B"], "after redo")
	Hands.click(_demo.panel.head.get_node(^"Undo") as Control)
	Hands.click(_demo.panel.head.get_node(^"Undo") as Control)
	expect_equal(_names(), [], "after two undos by the button")
	expect_true((_demo.panel.head.get_node(^"Undo") as Button).disabled, "nothing more to undo")
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	expect_equal(_names(), [], "after an undo too many")


func test_an_expression_is_typed() -> void:
	await _open_empty()
	var line := _part("Typing/Line") as LineEdit
	Hands.click(line)
	Hands.type(_window(), "s = sphere(e1, 2")
	await wait_frames(1)
	expect_equal((_part("Typing/Words") as Label).text, "column 17: expected ')', ',' or an operator, found the end; the '(' at column 11 is still open", "what is told while typing")
	Hands.type(_window(), ")")
	Hands.press_key(_window(), KEY_ENTER)
	expect_equal(_names(), ["s"], "entries")
	expect_equal(_scene().get_description("s"), "sphere, radius 2, centre (1, 0, 0)", "description")


func test_the_view_draws_what_the_document_has() -> void:
	await _open_empty()
	_demo.panel.edits.add("s", "sphere(e1, 2)")
	var node := _demo.find_children("*", "GANode3D", true, false)[0] as GANode3D
	expect_equal(node.entry, &"s", "entry that is drawn")
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	await wait_frames(2)
	expect_equal(_demo.find_children("*", "GANode3D", true, false).size(), 0, "drawn after undo")


func test_keys_rename_move_and_delete_the_selection() -> void:
	await _open_with({"a": "1", "b": "a + 1", "c": "3"})
	Hands.click(_row("c").find_child("Words", true, false) as Control)
	expect_equal(_demo.panel.list.selection, PackedStringArray(["c"]), "selection")
	Hands.press_key(_window(), KEY_UP, KEY_MASK_ALT)
	expect_equal(_names(), ["a", "c", "b"], "order after Alt and Up")
	Hands.press_key(_window(), KEY_F2)
	Hands.type(_window(), "d")
	Hands.press_key(_window(), KEY_ENTER)
	expect_equal(_names(), ["a", "d", "b"], "names after F2")
	# The view has the focus after a click into it.
	Hands.click(_view(), MOUSE_BUTTON_RIGHT)
	_demo.panel.list.select(["d"])
	Hands.press_key(_window(), KEY_DELETE)
	expect_equal(_names(), ["a", "b"], "names after Delete")
	_demo.panel.list.select(["a"])
	Hands.press_key(_window(), KEY_DELETE)
	var question := _demo.panel.get_node(^"EntryMenu/Question") as ConfirmationDialog
	expect_true(question.visible, "a question before what others depend on goes")
	question.get_ok_button().pressed.emit()
	expect_equal(_names(), ["b"], "names after the answer")
	expect_equal(_scene().get_error("b"), "column 1: there is no entry 'a'", "error of what lost it")


func test_the_mouse_turns_moves_and_zooms_the_view() -> void:
	await _open_empty()
	var camera := _demo.get_viewport_camera()
	var before := camera.global_transform
	Hands.drag(_view(), Vector2(0.5, 0.5), _view(), Vector2(0.6, 0.5), MOUSE_BUTTON_RIGHT)
	expect_true(camera.global_basis.z.angle_to(before.basis.z) > 0.2, "the view turned")
	expect_near(camera.global_position.y, before.origin.y, 1e-4, "height after a level drag")
	before = camera.global_transform
	Hands.drag(_view(), Vector2(0.5, 0.5), _view(), Vector2(0.6, 0.5), MOUSE_BUTTON_MIDDLE)
	expect_vector_near(camera.global_basis.z, before.basis.z, 1e-5, "direction of the view after moving along")
	expect_true((camera.global_position - before.origin).normalized().dot(before.basis.x) < -0.999, "moved against the drag")
	var distance := camera.position.z
	Hands.click(_view(), MOUSE_BUTTON_WHEEL_UP)
	expect_near(camera.position.z, distance / 1.1, 1e-4, "distance after a step of the wheel")


func test_objects_are_selected_and_dragged_in_the_view() -> void:
	await _open_with({"A": "point(0, 0, 0)", "s": "sphere(A, 1)"})
	var place := _demo.get_viewport_camera().unproject_position(Vector3.ZERO)
	_drag_in_view(place, place)
	expect_equal(_demo.panel.list.selection, PackedStringArray(["A"]), "selection after a click at the point")
	_drag_in_view(place, place + Vector2(120, 0))
	var to: Vector3 = _scene().get_parameters("A")["position"]
	expect_vector_near(Vector3(_demo.get_viewport_camera().unproject_position(to).x, 0, 0), Vector3(place.x + 120.0, 0, 0), 1.0, "where the point is seen")
	expect_vector_near(_scene().get_value("s").classify()["center"] as Vector3, to, 1e-5, "centre of what depends on it")
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	expect_equal(_scene().get_expression("A"), "point(0, 0, 0)", "after one undo of the drag")


func test_a_kind_is_chosen_and_added_by_clicks() -> void:
	await _open_empty()
	var menu := _demo.find_child("Adding", true, false) as MenuButton
	menu.get_popup().index_pressed.emit(5)
	expect_equal((_demo.find_child("Keys", true, false) as Label).text.begins_with("Click to add: Sphere"), true, "what is told")
	var place := _demo.get_viewport_camera().unproject_position(Vector3(1, 0, 2))
	_drag_in_view(place, place)
	expect_equal(_scene().get_value("s1").classify()["kind"], "sphere", "what is added")
	expect_vector_near(_scene().get_value("s1").classify()["center"] as Vector3, Vector3(1, 0, 2), 0.02, "its place on the ground")
	Hands.press_key(_window(), KEY_ESCAPE)
	_drag_in_view(place + Vector2(0, 150), place + Vector2(0, 150))
	expect_equal(_names(), ["s1"], "entries after Escape and a click")


func test_an_example_is_opened_from_its_menu() -> void:
	await _open_empty()
	Hands.click(_demo.panel.head.get_node(^"ExamplesButton") as Control)
	var examples := _demo.panel.head.find_child("Examples", true, false) as PopupMenu
	expect_true(examples.visible, "the menu being open")
	examples.hide()
	examples.index_pressed.emit(0)
	expect_equal(_demo.panel.document.scene.get_scene_attribute("title"), "Circle through three points", "title of what is shown")
	expect_true((_demo.panel.top.get_node(^"Description") as Control).visible, "a description")
	var view := ViewPoint.of(_scene())
	expect_vector_near(_demo.get_viewport_camera().global_position, view.from, 1e-3, "where it is looked at from")


func test_f_frames_the_selection() -> void:
	await _open_with({"s": "sphere(point(10, 20, 30), 2)", "t": "sphere(point(0, 0, 0), 1)"})
	_demo.panel.list.select(["s"])
	Hands.click(_view(), MOUSE_BUTTON_RIGHT)
	Hands.press_key(_window(), KEY_F)
	var camera := _demo.get_viewport_camera()
	var seen := camera.global_transform.affine_inverse() * Vector3(10, 20, 30)
	expect_vector_near(Vector3(seen.x, seen.y, 0.0), Vector3.ZERO, 1e-3, "the sphere's place in the view")
	expect_true(-seen.z > 5.0 and -seen.z < 20.0, "distance: %s" % -seen.z)


func test_coefficients_are_dragged_and_typed() -> void:
	await _open_with({"v": "e1 + 2 e2"})
	_demo.panel.list.select(["v"])
	var panel := _demo.panel.bottom.get_node(^"Coefficients") as FoldableContainer
	panel.expand()
	await wait_frames(3)
	var field := panel.find_child("e1", true, false) as NumberField
	expect_true(field is DragField, "the game's own field")
	Hands.drag(field, Vector2(0.2, 0.5), field, Vector2(0.7, 0.5))
	var dragged := _scene().get_value("v").coefficients[1]
	expect_true(dragged > 1.2 and dragged < 2.0, "e1 after dragging: %s" % dragged)
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	expect_equal(_scene().get_expression("v"), "e1 + 2 e2", "after one undo of the drag")
	Hands.click(field)
	Hands.type(_window(), "3/4")
	Hands.press_key(_window(), KEY_ENTER)
	expect_equal(_scene().get_value("v").coefficients[1], 0.75, "e1 after typing")
	Hands.click(field)
	Hands.type(_window(), "nonsense")
	Hands.press_key(_window(), KEY_ENTER)
	expect_equal(_scene().get_value("v").coefficients[1], 0.75, "e1 after typing what is no number")


func test_a_row_is_dragged_to_another_place() -> void:
	await _open_with({"a": "1", "b": "2", "c": "3", "d": "4"})
	var last := _row("d").find_child("Words", true, false) as Control
	var first := _row("a").find_child("Name", true, false) as Control
	Hands.drag(last, Vector2(0.3, 0.5), first, Vector2(0.5, 0.2))
	expect_equal(_names(), ["d", "a", "b", "c"], "order after dragging the last to the top")
	Hands.drag(_row("d").find_child("Words", true, false) as Control, Vector2(0.3, 0.5), _row("b"), Vector2(0.6, 0.95))
	expect_equal(_names(), ["a", "b", "d", "c"], "order after dragging it down by two")
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	expect_equal(_names(), ["d", "a", "b", "c"], "order after one undo")


func test_a_line_shows_where_a_dragged_row_goes() -> void:
	await _open_with({"a": "1", "b": "2"})
	var from := Hands.place_in(_row("b").find_child("Words", true, false) as Control, Vector2(0.3, 0.5))
	var to := Hands.place_in(_row("a"), Vector2(0.4, 0.1))
	Hands.press(_window(), from, true)
	for step in 6:
		Hands.move(_window(), from.lerp(to, step / 5.0), MOUSE_BUTTON_MASK_LEFT, (to - from) / 5.0)
	expect_equal(_row("a").drop_side, EntryRow.Drop.ABOVE, "side of the line")
	expect_equal(_row("b").drop_side, EntryRow.Drop.NONE, "side at the other row")
	Hands.press(_window(), to, false)
	expect_equal(_row("a").drop_side, EntryRow.Drop.NONE, "side after dropping")
	expect_equal(_names(), ["b", "a"], "order")


func test_the_range_of_a_slider_is_set_as_one_step() -> void:
	await _open_with({"k": "2"})
	var dialog := await _open_slider_range("k")
	expect_equal((dialog.find_child("From", true, false) as LineEdit).text, "-5.0", "the smallest by default")
	(dialog.find_child("From", true, false) as LineEdit).text = "4"
	(dialog.find_child("To", true, false) as LineEdit).text = "3"
	(dialog.find_child("To", true, false) as LineEdit).text_changed.emit("3")
	expect_equal((dialog.find_child("Error", true, false) as Label).text, "From has to be less than To.", "what is wrong")
	expect_true(dialog.get_ok_button().disabled, "no way to set it")
	(dialog.find_child("From", true, false) as LineEdit).text = "1"
	(dialog.find_child("Step", true, false) as LineEdit).text = "0.5"
	(dialog.find_child("Step", true, false) as LineEdit).text_changed.emit("0.5")
	dialog.get_ok_button().pressed.emit()
	var slider := _row("k").find_child("Slider", true, false) as HSlider
	expect_equal([slider.min_value, slider.max_value, slider.step, slider.value], [1.0, 3.0, 0.5, 2.0], "the slider")
	expect_equal(_scene().get_entry_attributes("k").size(), 3, "attributes of the entry")
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	expect_equal(_scene().get_entry_attributes("k").size(), 0, "attributes after one undo")
	expect_equal([slider.min_value, slider.max_value, slider.step], [-5.0, 5.0, 0.01], "the slider after undo")


func test_a_broken_range_of_a_slider_is_as_by_default() -> void:
	await _open_with({"k": "2"})
	_scene().set_entry_attribute("k", "slider/min", 7.0)
	_scene().set_entry_attribute("k", "slider/max", "many")
	var slider := _row("k").find_child("Slider", true, false) as HSlider
	expect_equal([slider.min_value, slider.max_value, slider.step], [-5.0, 5.0, 0.01], "the slider")


func test_json_is_copied_saved_opened_and_pasted() -> void:
	await _open_with({"a": "point(1, 2, 3)", "b": "a ^ einf"})
	var text := _scene().to_json()
	_demo.panel.file_menu.save(SAVED)
	expect_equal(FileAccess.get_file_as_string(SAVED), text, "the file")
	expect_true(not _demo.panel.document.is_unsaved(), "nothing unsaved")
	Hands.click(_part("Objects/sphere"))
	_demo.panel.file_menu.open(SAVED)
	expect_equal(_names(), ["a", "b"], "entries after opening")
	expect_true(not _demo.host.own_history.has_undo(), "nothing to undo in what was opened")
	_demo.panel.file_menu.paste("[%s]" % ", ".join(_numbers(2.0)))
	expect_equal(_scene().get_description(_names()[-1] as String), "number 2", "32 pasted numbers")
	_demo.panel.file_menu.paste("words")
	expect_equal(_demo.get_notice(), "The clipboard has neither a scene of the playground as JSON nor a list of 32 numbers. Copy one of them first.", "what is told")
	DirAccess.remove_absolute(SAVED)


func test_unsaved_work_is_there_at_the_next_start() -> void:
	DirAccess.remove_absolute(STATE)
	await _open_empty(STATE)
	Hands.click(_part("Objects/circle"))
	_demo.set_light(true)
	var text := _scene().to_json()
	_demo.get_parent().remove_child(_demo)
	_demo.free()
	_open(STATE)
	await wait_frames(2)
	expect_equal(_scene().to_json(), text, "the document")
	expect_true(_demo.panel.document.is_unsaved(), "still unsaved")
	expect_equal(_demo.theme.get_color(&"font_color", &"Editor"), PlaygroundTheme.palette(true)[&"text"], "the light look")
	_demo.state_path = ""
	DirAccess.remove_absolute(STATE)


func test_escape_first_clears_the_selection() -> void:
	await _open_with({"a": "1"})
	_demo.panel.list.select(["a"])
	Hands.press_key(_window(), KEY_ESCAPE)
	expect_equal(_demo.panel.list.selection.size(), 0, "selection")


## What the panel asks of a theme is in both of the game's.
func test_themes_have_what_the_panel_asks_for() -> void:
	for light: bool in [false, true]:
		var theme := PlaygroundTheme.make(light)
		for icon: StringName in [&"GuiVisibilityVisible", &"GuiVisibilityHidden", &"GuiTabMenuHl", &"StatusError"]:
			expect_true(theme.has_icon(icon, &"EditorIcons"), "icon %s" % icon)
			expect_equal(theme.get_icon(icon, &"EditorIcons").get_size(), Vector2(16, 16), "size of %s" % icon)
		for color: StringName in [&"font_color", &"error_color", &"accent_color"]:
			expect_true(theme.has_color(color, &"Editor"), "colour %s" % color)
		expect_true(theme.has_stylebox(&"selected", &"Tree"), "the selection's box")
		expect_equal(theme.get_type_variation_base(&"FlatButton"), &"Button", "flat buttons")


func _open(state_path := "") -> void:
	var packed: PackedScene = load("res://demos/playground/playground.tscn")
	_demo = packed.instantiate()
	_demo.state_path = state_path
	add_node(_demo)


func _open_empty(state_path := "") -> void:
	await _open_with({}, state_path)


func _open_with(entries: Dictionary[String, String], state_path := "") -> void:
	_open(state_path)
	var scene := GAScene.new()
	for entry in entries:
		scene.add_entry(entry, entries[entry])
	_demo.panel.document.show_scene(scene, "")
	await wait_frames(3)


func _open_slider_range(entry: String) -> ConfirmationDialog:
	var menu := _demo.panel.get_node(^"EntryMenu") as PopupMenu
	Hands.click(_row(entry).find_child("Menu", true, false) as Control)
	var items := range(menu.item_count).map(func(index: int) -> String: return menu.get_item_text(index))
	menu.hide()
	menu.id_pressed.emit(menu.get_item_id(items.find("Slider Range...")))
	await wait_frames(2)
	return menu.get_node(^"SliderRange")


func _numbers(first: float) -> PackedStringArray:
	var numbers := PackedStringArray([str(first)])
	for index in 31:
		numbers.append("0")
	return numbers


## Between places in the view.
func _drag_in_view(from: Vector2, to: Vector2) -> void:
	Hands.drag(_view(), from / _view().size, _view(), to / _view().size)


func _part(path: String) -> Control:
	return _demo.panel.get_node(path)


func _view() -> Control:
	return _demo.get_node(^"%View")


func _row(entry: String) -> EntryRow:
	return _demo.panel.list.find_row(entry)


func _scene() -> GAScene:
	return _demo.panel.document.scene


func _names() -> Array:
	return Array(_scene().get_names())


func _window() -> Viewport:
	return _demo.get_viewport()
