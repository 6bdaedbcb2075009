@tool
extends EditorPlugin
## Drives the dock as a person would, one step after another; each mistake prints a line that begins with [probe] FAIL.
## Pictures of the dock go to the files of the user arguments --dock-picture=FILE and --wide-picture=FILE.

const Hands := preload("hands.gd")
const PictureComparison := preload("res://tests/pictures/picture_comparison.gd")

const DOCK_NAME := ^"GAPlayground"
## Option: the picture to compare with.
const REFERENCE := "--dock-reference="
const EDITED_SCENE := "res://demos/interpolation/interpolation.tscn"
const SAVED := "res://probe_scene.tres"
const SETTLING_FRAMES := 6
const FIRST_FRAMES := 40

var _steps: Array[Callable] = [
	_open_dock, _add_points, _type_wrong, _see_error, _type_right, _see_description, _join, _edit_in_place, _rename, _undo_rename, _redo_rename, _refuse_rename, _see_refusal,
	_hide, _add_dual, _slide_add, _slide, _undo_slide, _coefficients_open, _coefficient, _undo_coefficient, _reorder, _drag_row, _ask_to_delete, _answer, _see_deleted,
	_undo_delete, _take_picture, _save, _new, _reopen, _paste, _show_tab_menu, _float, _edit_floating, _see_floating, _see_docked, _close, _open_again, _disable, _enable,
	_after_restart, _open_edited_scene, _create_node, _end,
]
var _frames := -FIRST_FRAMES
var _step := 0
var _before := ""
var _said := 0


func _process(_delta: float) -> void:
	if DisplayServer.get_name() == "headless" or EditorInterface.get_resource_filesystem().is_scanning():
		return
	_frames += 1
	if _frames >= SETTLING_FRAMES and _step < _steps.size():
		_frames = 0
		_step += 1
		_steps[_step - 1].call()


func _open_dock() -> void:
	_dock().make_visible()
	_expect(_names(), [], "entries at the start")


func _add_points() -> void:
	Hands.click(_part("Objects/point"))
	Hands.click(_part("Objects/point"))
	_expect(_names(), ["A", "B"], "two points by buttons")
	_expect(_scene().get_expression("B"), "point(1, 0, 0)", "place of the second point")


func _type_wrong() -> void:
	Hands.click(_line())
	Hands.type(_line().get_viewport(), "s = sphere(A,")


func _see_error() -> void:
	_expect(_typed_words().text.begins_with("column 14: expected"), true, "what is said while typing: %s" % _typed_words().text)
	Hands.press_key(_line().get_viewport(), KEY_ENTER)
	_expect(_names(), ["A", "B"], "entries after a wrong line")


func _type_right() -> void:
	Hands.type(_line().get_viewport(), " 2)")


func _see_description() -> void:
	_expect(_typed_words().text, "sphere, radius 2, centre (0, 0, 0)", "description while typing")
	Hands.press_key(_line().get_viewport(), KEY_ENTER)
	_expect(_names(), ["A", "B", "s"], "entries after a right line")


func _join() -> void:
	Hands.click(_row_part("A", "Words"))
	Hands.click(_row_part("B", "Words"), MOUSE_BUTTON_LEFT, true)
	Hands.click(_part("Combinations/join"))
	_expect(_scene().get_expression("pair1"), "join(A, B)", "join of both points")
	_expect(_words_of("pair1"), "point pair, radius 0.5, centre (0.5, 0, 0), direction (-1, 0, 0)", "words of the join")


func _edit_in_place() -> void:
	var edit := _row_part("B", "Expression") as LineEdit
	Hands.write_over(edit, "point(0, 4, 0)")
	Hands.press_key(edit.get_viewport(), KEY_ENTER)
	_expect(_scene().get_expression("B"), "point(0, 4, 0)", "expression edited in place")
	_expect(_words_of("pair1"), "point pair, radius 2, centre (0, 2, 0), direction (0, -1, 0)", "what follows from it")


func _rename() -> void:
	var edit := _row_part("A", "Name") as LineEdit
	Hands.write_over(edit, "apex")
	Hands.press_key(edit.get_viewport(), KEY_ENTER)
	_expect(_scene().get_expression("pair1"), "join(apex, B)", "references after renaming")


func _undo_rename() -> void:
	_undo()
	_expect(_names(), ["A", "B", "s", "pair1"], "names after undo")
	_expect((_row_part("A", "Name") as LineEdit).text, "A", "name in the row after undo")


func _redo_rename() -> void:
	_redo()
	_expect(_names(), ["apex", "B", "s", "pair1"], "names after redo")


func _refuse_rename() -> void:
	var edit := _row_part("B", "Name") as LineEdit
	Hands.write_over(edit, "e1")


func _see_refusal() -> void:
	var edit := _row_part("B", "Name") as LineEdit
	_expect(_words_of("B").contains("cannot be a name"), true, "refusal while typing: %s" % _words_of("B"))
	Hands.press_key(edit.get_viewport(), KEY_ESCAPE)
	_expect(_names(), ["apex", "B", "s", "pair1"], "names after a refusal")


func _hide() -> void:
	Hands.click(_row_part("s", "Eye"))
	_expect(_scene().get_entry_attribute("s", "visible"), false, "visibility after a click")
	Hands.click(_row_part("s", "Label"))
	_expect(_scene().get_entry_attribute("s", "label"), false, "label after a click")
	_undo()
	_undo()
	_expect(_scene().get_entry_attributes("s").get("visible", true), true, "visibility after undo")


## The toggle makes of the next object its dual.
func _add_dual() -> void:
	Hands.click(_part("Objects/dual"))
	Hands.click(_part("Objects/plane"))
	_expect(_words_of("p1"), "dual plane, distance 0, normal (0, 1, 0)", "a dual plane by buttons")
	Hands.click(_part("Objects/dual"))
	_undo()


func _slide_add() -> void:
	Hands.click(_part("Objects/scalar"))
	_expect(_scene().get_expression("k1"), "1", "number")


func _slide() -> void:
	_before = _scene().document
	Hands.drag(_row_part("k1", "Slider"), Vector2(0.6, 0.5), Vector2(0.9, 0.5))
	_expect(_scene().get_value("k1").coefficients[0] > 3.0, true, "number after sliding: %s" % _scene().get_expression("k1"))


func _undo_slide() -> void:
	_undo()
	_expect(_scene().document, _before, "document after one undo of a drag")


func _coefficients_open() -> void:
	Hands.click(_row_part("B", "Words"))
	_coefficients().expand()


func _coefficient() -> void:
	_before = _scene().document
	var slider := _number("e1")
	_expect(slider.read_only, false, "a free object being editable")
	_expect(_number("e2").value, 4.0, "e2 of B")
	slider.value = 2.5
	_expect(_scene().get_value("B").coefficients[1], 2.5, "e1 after editing")


func _undo_coefficient() -> void:
	_undo()
	_expect(_scene().document, _before, "document after undoing a coefficient")
	Hands.click(_row_part("pair1", "Words"))
	_expect(_number("e1").read_only, true, "what depends on others")


func _reorder() -> void:
	Hands.click(_row_part("s", "Words"))
	Hands.press_key(_line().get_viewport(), KEY_UP, 0, false, false, true)
	_expect(_names(), ["apex", "s", "B", "pair1", "k1"], "order after Alt and Up")
	_undo()


func _drag_row() -> void:
	var from := _row_part("pair1", "Words")
	var first: Control = _part("Entries").call(&"find_row", "apex")
	var to := from.get_global_transform().affine_inverse() * (first.get_global_transform() * Vector2(first.size.x / 2.0, 2.0))
	Hands.drag(from, Vector2(0.3, 0.5), to / from.size)
	_expect(_names(), ["pair1", "apex", "B", "s", "k1"], "order after dragging a row to the top")
	_undo()
	_expect(_names(), ["apex", "B", "s", "pair1", "k1"], "order after undoing the drag")
	_part("Entries").call(&"scroll_to", "apex")


func _ask_to_delete() -> void:
	Hands.click(_row_part("apex", "Words"))
	Hands.press_key(_line().get_viewport(), KEY_DELETE)
	_expect(_question().visible, true, "a question before deleting")
	_expect(_question().dialog_text.begins_with("s, pair1 depend on apex"), true, "what depends on it: %s" % _question().dialog_text)


func _answer() -> void:
	_question().get_ok_button().pressed.emit()


func _see_deleted() -> void:
	_expect(_names(), ["B", "s", "pair1", "k1"], "names after deleting")
	_expect(_scene().get_error("s"), "column 8: there is no entry 'apex'", "error of what lost it")


func _undo_delete() -> void:
	_undo()
	_expect(_scene().get_error("s"), "", "error after undo")
	Hands.click(_row_part("s", "Words"))


func _take_picture() -> void:
	_save_picture_of(_dock().get_viewport(), "--dock-picture=")
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with(REFERENCE):
			var compared := PictureComparison.compare(_picture_of(_dock().get_viewport()), Image.load_from_file(argument.trim_prefix(REFERENCE)))
			_expect(compared.is_alike(), true, compared.describe())


func _save() -> void:
	_before = _scene().document
	_file().call(&"save", SAVED)
	_expect(FileAccess.file_exists(SAVED), true, "the saved file")


func _new() -> void:
	_file().get_popup().id_pressed.emit(0)
	_expect(_names(), [], "entries of a new scene")


func _reopen() -> void:
	_file().call(&"open", SAVED)
	_expect(_scene().document, _before, "document after opening it")
	_expect(_words_of("s"), "sphere, radius 2, centre (0, 0, 0)", "row after opening")


func _paste() -> void:
	var numbers := PackedStringArray()
	for index in 32:
		numbers.append("2" if index == 0 else "0")
	DisplayServer.clipboard_set("[%s]" % ", ".join(numbers))
	_file().get_popup().id_pressed.emit(5)
	_expect(_scene().get_description(_names()[-1]), "number 2", "32 pasted numbers")
	_undo()
	_expect(_scene().document, _before, "document after undoing a paste")


## By the menu of its tab.
func _show_tab_menu() -> void:
	var tabs := (_dock().get_parent() as TabContainer)
	var bar := tabs.get_tab_bar()
	var middle := bar.get_tab_rect(tabs.get_tab_idx_from_control(_dock())).get_center()
	Hands.click(bar, MOUSE_BUTTON_RIGHT, false, middle / bar.size)


func _float() -> void:
	for menu in get_tree().root.find_children("*", "DockContextPopup", true, false):
		for button: Button in menu.find_children("*", "Button", true, false):
			if button.text == "Make Floating":
				button.pressed.emit()


func _edit_floating() -> void:
	_expect(_dock().get_window() != get_window(), true, "a window of its own")
	_before = _scene().document
	(_part("Objects/sphere") as Button).pressed.emit()
	_expect(_scene().get_value(_names()[-1]).classify()["kind"], &"sphere", "what is added in the window")
	_undo()
	_expect(_scene().document, _before, "document after undoing in the window")
	_dock().get_window().size = Vector2i(600, 500)


func _see_floating() -> void:
	_save_picture_of(_dock().get_viewport(), "--wide-picture=")
	_dock().get_window().close_requested.emit()


func _see_docked() -> void:
	_expect(_dock().get_window() == get_window(), true, "the dock back in the editor's window")


func _close() -> void:
	_dock().close()


func _open_again() -> void:
	_dock().open()
	_dock().make_visible()
	_expect(_words_of("s"), "sphere, radius 2, centre (0, 0, 0)", "row after closing and opening")


func _disable() -> void:
	EditorInterface.set_plugin_enabled("ga_godot", false)


func _enable() -> void:
	_expect(_dock() == null, true, "no dock without the plugin")
	EditorInterface.set_plugin_enabled("ga_godot", true)


func _after_restart() -> void:
	_dock().make_visible()
	_expect(_scene().document, _before, "document after the plugin was off and on")


func _open_edited_scene() -> void:
	EditorInterface.open_scene_from_path(EDITED_SCENE)


## By the menu of an entry; the class of the node may be missing in the library, and the item then is.
func _create_node() -> void:
	var menu := _dock().get_node("Panel/EntryMenu") as PopupMenu
	Hands.click(_row_part("s", "Words"))
	(_row_part("s", "Menu") as Button).pressed.emit()
	var items := range(menu.item_count).map(func(index: int) -> String: return menu.get_item_text(index))
	menu.hide()
	_expect(items.has("Create Node"), ClassDB.class_exists(&"GANode3D"), "the item Create Node")
	if not items.has("Create Node"):
		return
	var root := EditorInterface.get_edited_scene_root()
	menu.id_pressed.emit(menu.get_item_id(items.find("Create Node")))
	var node := root.get_node_or_null(^"s")
	_expect(node != null and node.owner == root and node.get(&"scene") == _scene(), true, "a node that follows the entry")
	get_undo_redo().get_history_undo_redo(get_undo_redo().get_object_history_id(root)).undo()
	_expect(root.has_node(^"s"), false, "the node after undo")


func _end() -> void:
	print("[probe] %d expectations" % _said)
	print("[probe] done")
	get_tree().quit()


func _save_picture_of(viewport: Viewport, option: String) -> void:
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with(option):
			_expect(_picture_of(viewport).save_png(argument.trim_prefix(option)), OK, "saving the picture")


func _picture_of(viewport: Viewport) -> Image:
	return viewport.get_texture().get_image().get_region(Rect2i(_dock().get_global_rect()))


func _undo() -> void:
	_history().undo()


func _redo() -> void:
	_history().redo()


func _history() -> UndoRedo:
	return get_undo_redo().get_history_undo_redo(EditorUndoRedoManager.GLOBAL_HISTORY)


func _dock() -> EditorDock:
	var found := get_tree().root.find_children("GAPlayground", "EditorDock", true, false)
	return found[0] if not found.is_empty() else null


func _part(path: String) -> Control:
	return _dock().get_node("Panel/" + path)


func _coefficients() -> FoldableContainer:
	return _dock().find_child("Coefficients", true, false)


func _number(blade: String) -> EditorSpinSlider:
	return _coefficients().find_child(blade, true, false).get_child(0)


func _line() -> LineEdit:
	return _part("Typing/Line")


func _typed_words() -> Label:
	return _part("Typing/Words")


func _file() -> MenuButton:
	return _dock().find_child("File", true, false)


func _question() -> ConfirmationDialog:
	return _dock().get_node("Panel/EntryMenu/Question")


func _row_part(entry: String, part: String) -> Control:
	var row: Control = _part("Entries").call(&"find_row", entry)
	return row.find_child(part, true, false) if row != null else null


func _words_of(entry: String) -> String:
	return (_row_part(entry, "Words") as Label).text


func _scene() -> GAScene:
	var document: RefCounted = _dock().get(&"document")
	return document.get(&"scene")


func _names() -> Array:
	return Array(_scene().get_names())


func _expect(got: Variant, wanted: Variant, what: String) -> void:
	_said += 1
	if got != wanted:
		print("[probe] FAIL %s: %s, expected %s" % [what, got, wanted])
