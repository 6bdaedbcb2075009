extends "res://tests/framework/playground_test.gd"
## The playground in a running game, operated by mouse and keyboard: its view, history and theme.

const PlaygroundTheme := preload("res://addons/ga_godot/playground/theme/playground_theme.gd")
const ViewPoint := preload("res://addons/ga_godot/playground/picture/view_point.gd")

const STATE := "user://test_playground.cfg"


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
	Hands.click(_demo.panel.toolbar.get_node(^"Undo") as Control)
	Hands.click(_demo.panel.toolbar.get_node(^"Undo") as Control)
	expect_equal(_names(), [], "after two undos by the button")
	expect_true((_demo.panel.toolbar.get_node(^"Undo") as Button).disabled, "nothing more to undo")
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	expect_equal(_names(), [], "after an undo too many")


func test_the_view_draws_what_the_document_has() -> void:
	await _open_empty()
	_demo.panel.edits.add("s", "sphere(e1, 2)")
	var node := _demo.find_children("*", "GANode3D", true, false)[0] as GANode3D
	expect_equal(node.entry, &"s", "entry that is drawn")
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	await wait_frames(2)
	expect_equal(_demo.find_children("*", "GANode3D", true, false).size(), 0, "drawn after undo")


func test_the_mouse_turns_moves_and_zooms_the_view() -> void:
	await _open_empty()
	var camera := _demo.get_viewport_camera()
	var before := camera.global_transform
	Hands.drag(_view(), Vector2(0.5, 0.5), _view(), Vector2(0.6, 0.5), MOUSE_BUTTON_RIGHT)
	expect_true(camera.global_basis.z.angle_to(before.basis.z) > 0.2, "the view turned")
	expect_near(camera.global_position.y, before.origin.y, 1e-4, "height after a level drag")
	before = camera.global_transform
	Hands.drag(_view(), Vector2(0.5, 0.5), _view(), Vector2(0.6, 0.5), MOUSE_BUTTON_MIDDLE)
	expect_vector_near(
		camera.global_basis.z, before.basis.z, 1e-5, "direction of the view after moving along"
	)
	expect_true(
		(camera.global_position - before.origin).normalized().dot(before.basis.x) < -0.999,
		"moved against the drag"
	)
	var distance := camera.position.z
	Hands.click(_view(), MOUSE_BUTTON_WHEEL_UP)
	expect_near(camera.position.z, distance / 1.1, 1e-4, "distance after a step of the wheel")


func test_objects_are_selected_and_dragged_in_the_view() -> void:
	await _open_with({"A": "point(0, 0, 0)", "s": "sphere(A, 1)"})
	var place := _demo.get_viewport_camera().unproject_position(Vector3.ZERO)
	_drag_in_view(place, place)
	expect_equal(
		_demo.panel.list.selection, PackedStringArray(["A"]), "selection after a click at the point"
	)
	_drag_in_view(place, place + Vector2(120, 0))
	var to: Vector3 = _scene().get_parameters("A")["position"]
	expect_vector_near(
		Vector3(_demo.get_viewport_camera().unproject_position(to).x, 0, 0),
		Vector3(place.x + 120.0, 0, 0),
		1.0,
		"where the point is seen"
	)
	expect_vector_near(
		_scene().get_value("s").classify()["center"] as Vector3,
		to,
		1e-5,
		"center of the dependent entry"
	)
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	expect_equal(_scene().get_expression("A"), "point(0, 0, 0)", "after one undo of the drag")


func test_a_kind_is_chosen_and_added_by_clicks() -> void:
	await _open_empty()
	var menu := _demo.find_child("Adding", true, false) as MenuButton
	menu.get_popup().index_pressed.emit(5)
	expect_equal(
		(_demo.find_child("Keys", true, false) as Label).text.begins_with("Click: add Sphere"),
		true,
		"hint"
	)
	var place := _demo.get_viewport_camera().unproject_position(Vector3(1, 0, 2))
	_drag_in_view(place, place)
	expect_equal(_scene().get_value("s1").classify()["kind"], "sphere", "what is added")
	expect_vector_near(
		_scene().get_value("s1").classify()["center"] as Vector3,
		Vector3(1, 0, 2),
		0.02,
		"its place on the ground"
	)
	Hands.press_key(_window(), KEY_ESCAPE)
	_drag_in_view(place + Vector2(0, 150), place + Vector2(0, 150))
	expect_equal(_names(), ["s1"], "entries after Escape and a click")


func test_an_example_is_opened_from_its_menu() -> void:
	await _open_empty()
	Hands.click(_demo.panel.toolbar.get_node(^"ExamplesButton") as Control)
	var examples := _demo.panel.toolbar.find_child("Examples", true, false) as PopupMenu
	expect_true(examples.visible, "the menu is open")
	examples.hide()
	examples.id_pressed.emit(0)
	expect_equal(
		_demo.panel.document.scene.get_scene_attribute("title"),
		"Circle through three points",
		"title of what is shown"
	)
	expect_true((_demo.panel.top.get_node(^"Description") as Control).visible, "a description")
	var view := ViewPoint.of(_scene())
	expect_vector_near(
		_demo.get_viewport_camera().global_position, view.from, 1e-3, "where it is looked at from"
	)


func test_f_frames_the_selection() -> void:
	await _open_with({"s": "sphere(point(10, 20, 30), 2)", "t": "sphere(point(0, 0, 0), 1)"})
	_demo.panel.list.select(["s"])
	Hands.click(_view(), MOUSE_BUTTON_RIGHT)
	Hands.press_key(_window(), KEY_F)
	var camera := _demo.get_viewport_camera()
	var seen := camera.global_transform.affine_inverse() * Vector3(10, 20, 30)
	expect_vector_near(
		Vector3(seen.x, seen.y, 0.0), Vector3.ZERO, 1e-3, "the sphere's place in the view"
	)
	expect_true(-seen.z > 5.0 and -seen.z < 20.0, "distance: %s" % -seen.z)


func test_colors_are_darker_before_a_light_background() -> void:
	await _open_with({"A": "point(1, 0, 0)"})
	var node := _demo.find_children("*", "GANode3D", true, false)[0] as GANode3D
	var dark := node.color
	_demo.set_light(true)
	expect_near(node.color.h, dark.h, 1e-3, "hue in the light")
	expect_true(
		node.color.v < 0.9 * dark.v,
		"value in the light: %s, in the dark: %s" % [node.color.v, dark.v]
	)
	_demo.set_light(false)
	expect_equal(node.color, dark, "color in the dark theme again")


func test_unsaved_work_is_restored_at_the_next_start() -> void:
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
	expect_equal(
		_demo.theme.get_color(&"font_color", &"Editor"),
		PlaygroundTheme.palette(true)[&"text"],
		"the light theme"
	)
	_demo.state_path = ""
	DirAccess.remove_absolute(STATE)


func test_escape_first_clears_the_selection() -> void:
	await _open_with({"a": "1"})
	_demo.panel.list.select(["a"])
	Hands.press_key(_window(), KEY_ESCAPE)
	expect_equal(_demo.panel.list.selection.size(), 0, "selection")


## Both themes of the game have the items that the panel uses.
func test_themes_have_the_items_that_the_panel_uses() -> void:
	for light: bool in [false, true]:
		var theme := PlaygroundTheme.make(light)
		for icon: StringName in [
			&"GuiVisibilityVisible", &"GuiVisibilityHidden", &"GuiTabMenuHl", &"StatusError"
		]:
			expect_true(theme.has_icon(icon, &"EditorIcons"), "icon %s" % icon)
			expect_equal(
				theme.get_icon(icon, &"EditorIcons").get_size(),
				Vector2(16, 16),
				"size of %s" % icon
			)
		for color: StringName in [&"font_color", &"error_color", &"accent_color"]:
			expect_true(theme.has_color(color, &"Editor"), "color %s" % color)
		expect_true(theme.has_stylebox(&"selected", &"Tree"), "the selection's box")
		expect_equal(theme.get_type_variation_base(&"FlatButton"), &"Button", "flat buttons")
