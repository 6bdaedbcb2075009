@tool
extends "step_probe.gd"
## Operates the interpolation lab in the dock. Each failure prints a line that starts with
## [probe] FAIL. The user arguments --lab-picture=FILE and --wide-picture=FILE save pictures of the
## dock.

const FoldPanel := preload("res://addons/ga_godot/playground/panel/fold_panel.gd")

const WIDE := Vector2i(600, 760)

var _before := ""


func get_steps() -> Array[Callable]:
	return [
		_open_dock,
		_add_motors,
		_type_another,
		_unfold,
		_check_suggestion,
		_select,
		_select_another,
		_use_selection,
		_check_drawing,
		_slide,
		_undo_slide,
		_play,
		_check_playing,
		_add_entry,
		_check_added,
		_undo_add,
		_rename,
		_check_renamed,
		_delete,
		_check_deleted,
		_undo_delete,
		_take_picture,
		_show_tab_menu,
		_float,
		_widen,
		_take_wide_picture,
		_end,
	]


func _open_dock() -> void:
	_dock().make_visible()
	_expect(_lab_panel().folded, true, "being folded at first")


func _add_motors() -> void:
	Hands.click(_panel().get_node(^"Objects/motor") as Control)
	Hands.click(_panel().get_node(^"Objects/motor") as Control)
	_expect(_names(), ["m1", "m2"], "two motors by buttons")


func _type_another() -> void:
	var line: LineEdit = _panel().get_node(^"Typing/Line")
	Hands.click(line)
	Hands.type(line.get_viewport(), "B = motor(-1.5 e1 + e2, rotor(e1 + 3 e2, deg(150)), 1.6)")
	Hands.press_key(line.get_viewport(), KEY_ENTER)


func _unfold() -> void:
	_expect(_names(), ["m1", "m2", "B"], "entries")
	Hands.click(_lab_panel(), MOUSE_BUTTON_LEFT, false, Vector2(0.3, 0.5))


func _check_suggestion() -> void:
	_expect(_lab_panel().folded, false, "being unfolded by a click")
	_expect(_chosen("From"), "m1", "from, as suggested")
	_expect(_chosen("To"), "m2", "to, as suggested")


func _select() -> void:
	Hands.click(_row_words("m1"))
	_list().call(&"scroll_to", "B")


func _select_another() -> void:
	Hands.click(_row_words("B"), MOUSE_BUTTON_LEFT, true)


func _use_selection() -> void:
	Hands.click(_lab_part("UseSelection"))
	_expect(_setting("to"), "B", "attribute to")
	_expect(_chosen("To"), "B", "to")


func _check_drawing() -> void:
	var drawings := get_tree().root.find_children("Interpolation", "Node3D", true, false)
	_expect(drawings.size(), 1, "drawings of the lab in the 3D viewports")
	var drawing: Node3D = drawings[0]
	_expect(drawing.is_visible_in_tree(), true, "its being seen")
	var body: Node3D = drawing.get_node(^"Screw/Body")
	var middle := MultivectorLerp.interpolate(
		_scene().get_value("m1"), _scene().get_value("B"), 0.5, MultivectorLerp.SCREW
	)
	_expect(
		body.transform.is_equal_approx(middle.to_transform()),
		true,
		"place of what moves by the screw"
	)


func _slide() -> void:
	_before = _scene().document
	var slider := _lab_part("Player").get_node(^"Slider") as Control
	Hands.drag(slider, Vector2(0.5, 0.5), slider, Vector2(0.3, 0.5))


func _undo_slide() -> void:
	var t: float = _setting("t")
	_expect(t > 0.2 and t < 0.45, true, "t after the drag, %s" % t)
	_undo()
	_expect(_scene().document, _before, "document after one undo")
	_redo()


func _play() -> void:
	Hands.click(_lab_part("Play"))


func _check_playing() -> void:
	var slider: HSlider = _lab_part("Player").get_node(^"Slider")
	_expect(slider.value != _setting("t"), true, "another t while it is played")
	Hands.click(_lab_part("Play"))
	_expect(
		_scene().get_scene_attribute("interpolation/t") != null,
		true,
		"attribute t, which playback does not change"
	)


func _add_entry() -> void:
	_before = _scene().document
	(_lab_part("AddEntry") as MenuButton).get_popup().id_pressed.emit(MultivectorLerp.SCREW)


func _check_added() -> void:
	_expect(_names(), ["m1", "m2", "B", "t", "m3"], "entries after adding the interpolation")
	_expect(
		_scene().get_expression("m3"),
		"interpolate_screw(m1, B, t)",
		"expression of the interpolation"
	)


func _undo_add() -> void:
	_undo()
	_expect(_scene().document, _before, "document after one undo")


func _rename() -> void:
	_edits().call(&"rename", "B", "finish")


func _check_renamed() -> void:
	_expect(_chosen("To"), "finish", "to, renamed")
	_expect(_message(), "B was renamed to finish.", "message")


func _delete() -> void:
	_edits().call(&"remove", PackedStringArray(["finish"]))


func _check_deleted() -> void:
	_expect(_message(), "finish no longer exists. Choose another entry, or undo.", "message")


func _undo_delete() -> void:
	_undo()
	_expect(_message(), "", "message after undo")


func _take_picture() -> void:
	_save_picture("--lab-picture=")


func _show_tab_menu() -> void:
	var tabs := _dock().get_parent() as TabContainer
	var bar := tabs.get_tab_bar()
	var middle := bar.get_tab_rect(tabs.get_tab_idx_from_control(_dock())).get_center()
	Hands.click(bar, MOUSE_BUTTON_RIGHT, false, middle / bar.size)


func _float() -> void:
	for menu in get_tree().root.find_children("*", "DockContextPopup", true, false):
		for button: Button in menu.find_children("*", "Button", true, false):
			if button.text == "Make Floating":
				button.pressed.emit()


func _widen() -> void:
	_dock().get_window().size = WIDE


func _take_wide_picture() -> void:
	_expect(_dock().get_window() != get_window(), true, "a window of its own")
	_save_picture("--wide-picture=")


func _save_picture(option: String) -> void:
	var picture := _dock().get_viewport().get_texture().get_image().get_region(
		Rect2i(_dock().get_global_rect())
	)
	_expect(picture.save_png(_option(option)), OK, "saving the picture")


func _undo() -> void:
	get_undo_redo().get_history_undo_redo(EditorUndoRedoManager.GLOBAL_HISTORY).undo()


func _redo() -> void:
	get_undo_redo().get_history_undo_redo(EditorUndoRedoManager.GLOBAL_HISTORY).redo()


func _dock() -> EditorDock:
	return get_tree().root.find_children("GAPlayground", "EditorDock", true, false)[0]


func _panel() -> Control:
	return _dock().get_node(^"Panel")


func _list() -> Control:
	return _panel().get_node(^"Entries")


func _edits() -> RefCounted:
	return _panel().get(&"edits")


func _scene() -> GAScene:
	var document: RefCounted = _panel().get(&"document")
	return document.get(&"scene")


func _names() -> Array:
	return Array(_scene().get_names())


func _setting(key: String) -> Variant:
	return _scene().get_scene_attribute("interpolation/" + key)


func _lab_panel() -> FoldPanel:
	return _panel().find_child("Interpolation", true, false)


func _lab_part(title: String) -> Control:
	return _lab_panel().find_child(title, true, false)


func _chosen(title: String) -> String:
	var choice: OptionButton = _lab_part(title)
	return choice.get_item_text(choice.selected)


func _message() -> String:
	var label: Label = _lab_part("Ends").get_node(^"Message")
	return label.text if label.visible else ""


func _row_words(entry: String) -> Control:
	var row: Control = _list().call(&"find_row", entry)
	return row.find_child("Message", true, false)
