@tool
extends "viewport_user.gd"
## Operates the playground in the editor's 3D viewport. The user argument --pictures=FOLDER saves
## pictures.

const EditedScene := preload("edited_scene.gd")
const PictureComparison := preload("res://tests/pictures/picture_comparison.gd")

const PICTURES := "--pictures="
## The reference picture of the viewport, if it is to be compared.
const REFERENCE := "--reference="
const EDITED_SCENE := "res://probe_view.tscn"
const OBJECTS: Dictionary[String, String] = {
	"A": "point(-2, 1, 0)",
	"s": "sphere(point(1.5, 1, 1), 0.8)",
	"c": "circle(point(-1, 1, -1), e2, 1)",
	"p": "plane(e2, 0.3)",
	"m": "motor(vector(0, 0, 2), rotor(e2, deg(90)), 1)",
	"l": "join(A, point(0, 0, -2)) ^ einf",
	"k": "meet(s, p)",
	"q": "sandwich(m, A)",
	"o": "!(c ^ einf) ^ einf",
}

var _before := ""


func get_steps() -> Array[Callable]:
	return [
		_open,
		_choose_kind,
		_click_ground,
		_check_added,
		_fill,
		_drag_point,
		_drag_radius,
		_drag_center,
		_drag_normal,
		_drag_offset,
		_drag_axis,
		_escape,
		_snap,
		_click_object,
		_hold,
		_check_held,
		_aim,
		_check_aim,
		_select_all,
		_hover,
		_take_picture,
		_select_mesh,
		_check_mesh,
		_select_node,
		_check_node,
		_drag_node,
		_check_kept,
		_new_document,
		_check_question,
		_deselect,
		_check_own,
		_hide,
		_check_hidden,
		_show_again,
		_close,
		_check_closed,
		_open_again,
		_save,
		_four,
		_check_four,
		_end,
	]


func _open() -> void:
	EditedScene.save(EDITED_SCENE)
	EditorInterface.open_scene_from_path(EDITED_SCENE)
	EditorInterface.set_main_screen_editor("3D")
	_dock().make_visible()


func _choose_kind() -> void:
	var adding := _tools().get_node(^"Adding") as MenuButton
	adding.get_popup().id_pressed.emit(0)
	Hands.click(_surface(), MOUSE_BUTTON_LEFT, false, Vector2(0.4, 0.7))


func _click_ground() -> void:
	_expect(Array(_scene().get_names()), ["A"], "a point by a click")
	var position: Vector3 = _scene().get_parameters("A").position
	_expect(position.y, 0.0, "its height")
	_expect(
		(
			_camera().unproject_position(position).distance_to(Vector2(0.4, 0.7) * _surface().size)
			< 2.0
		),
		true,
		"its place %s" % position
	)
	_expect(_selection(), PackedStringArray(["A"]), "selection in the dock")


func _check_added() -> void:
	Hands.press_key(_surface().get_viewport(), KEY_ESCAPE)
	_expect(_pointer().get(&"adding"), &"", "kind that a click adds after Esc")
	_undo()
	_expect(Array(_scene().get_names()), [], "entries after undo")


func _fill() -> void:
	var scene := _scene()
	for entry in OBJECTS:
		scene.add_entry(entry, OBJECTS[entry])
	for entry in OBJECTS:
		_expect(scene.get_error(entry), "", "error of %s" % entry)


func _drag_point() -> void:
	_select(["A"])
	_check_drag("A", "position", Vector2(60, -40), ["l", "q"])


func _drag_radius() -> void:
	_select(["s"])
	_check_drag("s", "radius", Vector2(40, 0), ["k"])


func _drag_center() -> void:
	_check_drag("s", "center", Vector2(-30, 30), ["k"])


func _drag_normal() -> void:
	_select(["c"])
	_check_drag("c", "normal", Vector2(30, 20), ["o"])


func _drag_offset() -> void:
	_select(["p"])
	_check_drag("p", "distance", Vector2(0, -30), ["k"])


func _drag_axis() -> void:
	_select(["m"])
	_check_drag("m", "axis", Vector2(25, 15), ["q"])
	_check_drag("m", "angle", Vector2(20, 5), ["q"], false)
	_check_drag("m", "translation", Vector2(20, 5), ["q"])


func _escape() -> void:
	_select(["A"])
	_before = _scene().document
	var place := _handle_place("A", "position")
	_move_mouse(place, 0)
	_press(place, true)
	_move_mouse(place + Vector2(50, 50), MOUSE_BUTTON_MASK_LEFT)
	_expect(_scene().document != _before, true, "a change while dragging")
	Hands.press_key(_surface().get_viewport(), KEY_ESCAPE)
	_expect(_scene().document, _before, "document after Escape")
	_press(place + Vector2(50, 50), false)


func _snap() -> void:
	_select(["A"])
	var place := _handle_place("A", "position")
	_drag(place, place + Vector2(33, 21), true)
	var position: Vector3 = _scene().get_parameters("A").position
	_expect(
		position.is_equal_approx(position.snappedf(0.1)), true, "a place on the grid: %s" % position
	)
	_undo()


func _click_object() -> void:
	_select([])
	_click_at(_scene().get_parameters("A").position as Vector3)
	_expect(_selection(), PackedStringArray(["A"]), "selection by a click on a point")
	var circle := _scene().get_value("k").classify()
	_click_at((circle["center"] as Vector3) + Vector3.BACK * (circle["radius"] as float))
	_expect(_selection(), PackedStringArray(["k"]), "selection by a click on a circle")


## Stops in the middle of a drag.
func _hold() -> void:
	_select(["s", "c"])
	var place := _handle_place("s", "radius")
	_move_mouse(place, 0)
	_press(place, true)
	_move_mouse(place + Vector2(-40, 0), MOUSE_BUTTON_MASK_LEFT)
	_before = _scene().document


func _check_held() -> void:
	_save_window("viewport_drag.png")
	_press(_handle_place("s", "radius"), false)
	_expect(_scene().document, _before, "document after the release")
	_undo()


func _aim() -> void:
	_pointer().set(&"adding", &"circle")
	_move_mouse(Vector2(0.75, 0.4) * _surface().size, 0)


func _check_aim() -> void:
	_save_window("viewport_adding.png")
	_pointer().set(&"adding", &"")


func _select_all() -> void:
	_select(["A", "s", "c", "p", "m"])


func _hover() -> void:
	_move_mouse(_handle_place("c", "normal"), 0)
	_expect(_pointer().get(&"hovered_handle") != null, true, "a handle under the mouse")


func _take_picture() -> void:
	var picture := get_tree().root.get_texture().get_image().get_region(
		Rect2i(_surface().get_global_rect())
	)
	picture.save_png(_option(PICTURES).path_join("viewport.png"))
	_save_window("viewport_editor.png")
	if not _option(REFERENCE).is_empty():
		var compared := PictureComparison.compare(picture, Image.load_from_file(_option(REFERENCE)))
		_expect(compared.is_alike(), true, compared.describe())


## The mesh lies in a plane of the document, which covers the view.
func _select_mesh() -> void:
	_before = _scene().document
	_click_at((_edited().get_node(^"Box") as Node3D).global_position)


func _check_mesh() -> void:
	_expect(_selected_nodes(), [_edited().get_node(^"Box")], "node selected by a click on a mesh")
	_expect(_selection().size(), 5, "entries selected in the dock, as before")


func _select_node() -> void:
	EditorInterface.get_selection().clear()
	var node := _edited().get_node(^"Node") as Node3D
	_click_at(node.to_global(Vector3(0, 0.5, 0)))


func _check_node() -> void:
	_expect(
		_selected_nodes(), [_edited().get_node(^"Node")], "node selected by a click on its object"
	)
	_expect(Array(_scene().get_names()), ["B", "t"], "entries in the dock")
	_expect(_selection(), PackedStringArray(["B"]), "entry selected in the dock")


func _drag_node() -> void:
	var node := _edited().get_node(^"Node") as Node3D
	var place := _handle_place("B", "position")
	_expect(
		_camera().unproject_position(node.to_global(Vector3(0, 0.5, 0))).distance_to(place) < 1.0,
		true,
		"a handle in the node's space"
	)
	_check_drag("B", "position", Vector2(30, -20), ["t"])
	EditorInterface.save_scene()


## The dock showed the scene of a node while the edited scene was saved.
func _check_kept() -> void:
	_expect(_selection(), PackedStringArray(["B"]), "entry selected in the dock after saving")
	var session := ConfigFile.new()
	session.load(
		EditorInterface.get_editor_paths().get_project_settings_dir().path_join("ga_playground.cfg")
	)
	_expect(
		session.get_value("session", "document", ""),
		_before,
		"the dock's own document in the saved session"
	)


## A new document would replace the dock's own, which is unsaved.
func _new_document() -> void:
	(_dock().find_child("File", true, false) as MenuButton).get_popup().id_pressed.emit(0)


func _check_question() -> void:
	var question: ConfirmationDialog = _dock().find_child("File", true, false).get(&"_question")
	_expect(question.visible, true, "a question before unsaved work is replaced")
	_expect(_scene().document, _before, "document while it is asked")
	question.hide()


func _deselect() -> void:
	EditorInterface.get_selection().clear()


func _check_own() -> void:
	_expect(_scene().document, _before, "the dock's own document afterwards")


func _hide() -> void:
	(_tools().get_node(^"Shown") as Button).button_pressed = false


func _check_hidden() -> void:
	_expect(_tool().is_visible_in_tree(), false, "objects while they are hidden")
	_select(["A"])
	var place := _camera().unproject_position(_scene().get_parameters("A").position as Vector3)
	_drag(place, place + Vector2(40, 0))
	_expect(_scene().document, _before, "document after dragging a hidden object")


func _show_again() -> void:
	(_tools().get_node(^"Shown") as Button).button_pressed = true
	_expect(_tool().is_visible_in_tree(), true, "objects when they are shown again")


func _close() -> void:
	_dock().close()


func _check_closed() -> void:
	_expect(_tool().is_visible_in_tree(), false, "objects while the dock is closed")
	_expect(_tools().visible, false, "the buttons above the viewport")


func _open_again() -> void:
	_dock().open()
	_dock().make_visible()


## Drawn objects are not part of the edited scene.
func _save() -> void:
	_expect(_tool().is_visible_in_tree(), true, "objects when the dock is open again")
	EditorInterface.save_scene()
	var saved := (
		(ResourceLoader.load(EDITED_SCENE, "", ResourceLoader.CACHE_MODE_IGNORE) as PackedScene)
		. get_state()
	)
	_expect(
		range(saved.get_node_count()).map(
			func(index: int) -> String: return saved.get_node_name(index)
		),
		["Root", "Box", "Node"],
		"nodes of the saved scene"
	)


func _four() -> void:
	for index in 4:
		var viewport := EditorInterface.get_editor_viewport_3d(index)
		_expect(
			viewport.find_world_3d() == _tool().get_world_3d(),
			true,
			"the world of viewport %d" % index
		)
	for menu in EditorInterface.get_editor_main_screen().find_children(
		"*", "PopupMenu", true, false
	):
		var popup := menu as PopupMenu
		for index in popup.item_count:
			if popup.get_item_text(index) == "4 Viewports":
				popup.id_pressed.emit(popup.get_item_id(index))


func _check_four() -> void:
	_save_window("viewport_four.png")


func _save_window(file: String) -> void:
	get_tree().root.get_texture().get_image().save_png(_option(PICTURES).path_join(file))
