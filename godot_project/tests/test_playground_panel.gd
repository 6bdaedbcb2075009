extends "res://tests/framework/playground_test.gd"
## The playground's panel, operated by mouse and keyboard: entry list, expression line,
## coefficients, sliders, files.

const DragField := preload("res://addons/ga_godot/playground/panel/drag_field.gd")
const FoldPanel := preload("res://addons/ga_godot/playground/panel/fold_panel.gd")
const NumberField := preload("res://addons/ga_godot/playground/panel/number_field.gd")

const SAVED := "user://test_playground.json"


func test_an_expression_is_typed() -> void:
	await _open_empty()
	var line := _part("Typing/Line") as LineEdit
	Hands.click(line)
	Hands.type(_window(), "s = sphere(e1, 2")
	await wait_frames(1)
	expect_equal(
		(_part("Typing/Message") as Label).text,
		"column 17: expected ')', ',' or an operator, found the end; the '(' at column 11 is not closed",
		"error while typing"
	)
	Hands.type(_window(), ")")
	Hands.press_key(_window(), KEY_ENTER)
	expect_equal(_names(), ["s"], "entries")
	expect_equal(_scene().get_description("s"), "sphere, radius 2, center (1, 0, 0)", "description")
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	expect_equal(_names(), [], "entries after undo, with the line still having the focus")


func test_keys_rename_move_and_delete_the_selection() -> void:
	await _open_with({"a": "1", "b": "a + 1", "c": "3"})
	Hands.click(_row("c").find_child("Message", true, false) as Control)
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
	expect_true(question.visible, "a question before deleting what others depend on")
	question.get_ok_button().pressed.emit()
	expect_equal(_names(), ["b"], "names after the answer")
	expect_equal(
		_scene().get_error("b"), "column 1: there is no entry 'a'", "error of the dependent entry"
	)


func test_coefficients_are_dragged_and_typed() -> void:
	await _open_with({"v": "e1 + 2 e2"})
	_demo.panel.list.select(["v"])
	var panel := _demo.panel.bottom.get_node(^"Coefficients") as FoldPanel
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
	expect_equal(
		_scene().get_value("v").coefficients[1],
		0.75,
		"e1 after typing something other than a number"
	)


func test_coefficients_scroll_to_the_grade_of_the_entry() -> void:
	await _open_with({"S": "sphere(point(1, 0, 0), 2)"})
	var panel := _demo.panel.bottom.get_node(^"Coefficients") as FoldPanel
	panel.expand()
	_demo.panel.list.select(["S"])
	await wait_frames(4)
	var field := panel.find_child("e1235", true, false) as Control
	expect_true(field.get_global_rect().intersects(panel.get_global_rect()), "e1235 in view")
	expect_true(
		panel.get_global_rect().end.y <= _demo.panel.get_global_rect().end.y, "the panel in view"
	)


func test_a_row_is_dragged_to_another_place() -> void:
	await _open_with({"a": "1", "b": "2", "c": "3", "d": "4"})
	var last := _row("d").find_child("Message", true, false) as Control
	var first := _row("a").find_child("Name", true, false) as Control
	Hands.drag(last, Vector2(0.3, 0.5), first, Vector2(0.5, 0.2))
	expect_equal(_names(), ["d", "a", "b", "c"], "order after dragging the last to the top")
	Hands.drag(
		_row("d").find_child("Message", true, false) as Control,
		Vector2(0.3, 0.5),
		_row("b"),
		Vector2(0.6, 0.95)
	)
	expect_equal(_names(), ["a", "b", "d", "c"], "order after dragging it down by two")
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	expect_equal(_names(), ["d", "a", "b", "c"], "order after one undo")
	await wait_frames(3)
	for row in _demo.panel.list.get_rows():
		expect_true(
			(row.find_child("Message", true, false) as Control).size.y < 30.0,
			"the description of %s fits its row" % row.entry
		)


func test_a_line_shows_where_a_dragged_row_goes() -> void:
	await _open_with({"a": "1", "b": "2"})
	var from := Hands.place_in(
		_row("b").find_child("Message", true, false) as Control, Vector2(0.3, 0.5)
	)
	var to := Hands.place_in(_row("a"), Vector2(0.4, 0.1))
	Hands.press(_window(), from, true)
	for step in 6:
		Hands.move(_window(), from.lerp(to, step / 5.0), MOUSE_BUTTON_MASK_LEFT, (to - from) / 5.0)
	expect_equal(_row("a").drop_side, EntryRow.Drop.ABOVE, "side of the line")
	expect_equal(_row("b").drop_side, EntryRow.Drop.NONE, "side at the other row")
	Hands.press(_window(), to, false)
	expect_equal(_row("a").drop_side, EntryRow.Drop.NONE, "side after dropping")
	expect_equal(_names(), ["b", "a"], "order")


func test_the_range_of_a_slider_is_set_in_one_action() -> void:
	await _open_with({"k": "2"})
	var dialog := await _open_slider_range("k")
	expect_equal(
		(dialog.find_child("From", true, false) as LineEdit).text, "-5", "the smallest by default"
	)
	(dialog.find_child("From", true, false) as LineEdit).text = "4"
	(dialog.find_child("To", true, false) as LineEdit).text = "3"
	(dialog.find_child("To", true, false) as LineEdit).text_changed.emit("3")
	expect_equal(
		(dialog.find_child("Error", true, false) as Label).text,
		"From must be less than To.",
		"error"
	)
	expect_true(dialog.get_ok_button().disabled, "the OK button is disabled")
	(dialog.find_child("From", true, false) as LineEdit).text = "1"
	(dialog.find_child("Step", true, false) as LineEdit).text = "0.5"
	(dialog.find_child("Step", true, false) as LineEdit).text_changed.emit("0.5")
	dialog.get_ok_button().pressed.emit()
	var slider := _row("k").find_child("Slider", true, false) as HSlider
	expect_equal(
		[slider.min_value, slider.max_value, slider.step, slider.value],
		[1.0, 3.0, 0.5, 2.0],
		"the slider"
	)
	expect_equal(_scene().get_entry_attributes("k").size(), 3, "attributes of the entry")
	Hands.press_key(_window(), KEY_Z, KEY_MASK_CTRL)
	expect_equal(_scene().get_entry_attributes("k").size(), 0, "attributes after one undo")
	expect_equal(
		[slider.min_value, slider.max_value, slider.step],
		[-5.0, 5.0, 0.01],
		"the slider after undo"
	)


func test_an_invalid_range_of_a_slider_is_replaced_by_the_default() -> void:
	await _open_with({"k": "2"})
	_scene().set_entry_attribute("k", "slider/min", 7.0)
	_scene().set_entry_attribute("k", "slider/max", "many")
	var slider := _row("k").find_child("Slider", true, false) as HSlider
	expect_equal([slider.min_value, slider.max_value, slider.step], [-5.0, 5.0, 0.01], "the slider")


func test_a_damaged_file_is_not_overwritten() -> void:
	await _open_empty()
	var text := '{"entries": [{"name": "a", "expression": "1"}, {"name": "b"}]}'
	var file := FileAccess.open(SAVED, FileAccess.WRITE)
	file.store_string(text)
	file.close()
	var place := "column 48: entry 'b' skipped: it has no expression"
	expect_error(
		(
			"GAScene.load_json_utf8: parts of the text could not be read; the rest was loaded:\n%s."
			% place
		)
	)
	_demo.panel.file_menu.open(SAVED)
	expect_equal(_names(), ["a"], "entries")
	expect_equal(_demo.panel.document.path, "", "the path of the scene")
	expect_equal(
		_demo.get_notice(),
		(
			"%s was only partly read and is shown as a new scene. The file is unchanged:\n%s"
			% [SAVED, place]
		),
		"notice"
	)
	_demo.panel.file_menu.save("user://no/folder.json")
	expect_equal(
		_demo.get_notice(),
		(
			"user://no/folder.json cannot be saved: File not found. What was saved before is"
			+ " unchanged. Check the free space on the disk, or choose another location with"
			+ " Save As."
		),
		"notice"
	)
	expect_equal(FileAccess.get_file_as_string(SAVED), text, "the file")
	DirAccess.remove_absolute(SAVED)


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
	expect_equal(
		_demo.get_notice(),
		(
			"The clipboard contains neither a playground scene as JSON nor a list of 32 numbers."
			+ " Copy one of them first."
		),
		"notice"
	)
	DirAccess.remove_absolute(SAVED)
