@tool
extends "../chapter.gd"
## Entries: adding, typing, renaming, hiding, sliding, reordering, deleting, and undoing all of it.


func run() -> void:
	dock().make_visible()
	expect(names(), [], "entries at the start")
	await settle()
	await _add_points()
	await _type()
	await _join()
	await _rename()
	await _hide()
	await _add_dual()
	await _slide()
	await _reorder()
	await _drag_row()
	await _delete()


func _add_points() -> void:
	Hands.click(part("Objects/point"))
	Hands.click(part("Objects/point"))
	expect(names(), ["A", "B"], "two points by buttons")
	expect(scene().get_expression("B"), "point(1, 0, 0)", "place of the second point")
	await settle()


func _type() -> void:
	Hands.click(line())
	Hands.type(window(), "s = sphere(A,")
	await settle()
	expect_true(
		typed_words().text.begins_with("column 14: expected"),
		"error while typing: %s" % typed_words().text
	)
	Hands.press_key(window(), KEY_ENTER)
	expect(names(), ["A", "B"], "entries after a wrong line")
	Hands.type(window(), " 2)")
	await settle()
	expect(typed_words().text, "sphere, radius 2, center (0, 0, 0)", "description while typing")
	Hands.press_key(window(), KEY_ENTER)
	expect(names(), ["A", "B", "s"], "entries after a right line")
	await settle()


func _join() -> void:
	await select(["A", "B"])
	Hands.click(part("Combinations/join"))
	expect(scene().get_expression("pair1"), "join(A, B)", "join of both points")
	expect(
		words_of("pair1"),
		"point pair, radius 0.5, center (0.5, 0, 0), direction (-1, 0, 0)",
		"description of the join"
	)
	await settle()
	var edit := row_part("B", "Expression") as LineEdit
	Hands.write_over(edit, "point(0, 4, 0)")
	Hands.press_key(window(), KEY_ENTER)
	expect(scene().get_expression("B"), "point(0, 4, 0)", "expression edited in place")
	expect(
		words_of("pair1"),
		"point pair, radius 2, center (0, 2, 0), direction (0, -1, 0)",
		"description of the dependent entry"
	)
	await settle()


func _rename() -> void:
	Hands.write_over(row_part("A", "Name") as LineEdit, "apex")
	Hands.press_key(window(), KEY_ENTER)
	expect(scene().get_expression("pair1"), "join(apex, B)", "references after renaming")
	await settle()
	undo()
	expect(names(), ["A", "B", "s", "pair1"], "names after undo")
	expect((row_part("A", "Name") as LineEdit).text, "A", "name in the row after undo")
	await settle()
	redo()
	expect(names(), ["apex", "B", "s", "pair1"], "names after redo")
	await settle()
	Hands.write_over(row_part("B", "Name") as LineEdit, "e1")
	await settle()
	expect_true(
		words_of("B").begins_with("'e1' "), "error of a name while typing: %s" % words_of("B")
	)
	expect(words_of("B"), scene().get_name_error("e1"), "error of a name while typing")
	Hands.press_key(window(), KEY_ESCAPE)
	expect(names(), ["apex", "B", "s", "pair1"], "names after a refusal")
	await settle()


func _hide() -> void:
	Hands.click(row_part("s", "Eye"))
	expect(scene().get_entry_attribute("s", "visible"), false, "visibility after a click")
	Hands.click(row_part("s", "Label"))
	expect(scene().get_entry_attribute("s", "label"), false, "label after a click")
	undo()
	undo()
	expect(scene().get_entry_attributes("s").get("visible", true), true, "visibility after undo")
	await settle()


## The toggle adds objects as duals.
func _add_dual() -> void:
	Hands.click(part("Objects/dual"))
	Hands.click(part("Objects/plane"))
	expect(words_of("p1"), "dual plane, distance 0, normal (0, 1, 0)", "a dual plane by buttons")
	Hands.click(part("Objects/dual"))
	undo()
	await settle()


func _slide() -> void:
	Hands.click(part("Objects/scalar"))
	expect(scene().get_expression("k1"), "1", "number")
	await settle()
	var before := scene().document
	Hands.drag(
		row_part("k1", "Slider"), Vector2(0.6, 0.5), row_part("k1", "Slider"), Vector2(0.9, 0.5)
	)
	expect_true(
		scene().get_value("k1").coefficients[0] > 3.0,
		"number after sliding: %s" % scene().get_expression("k1")
	)
	await settle()
	undo()
	expect(scene().document, before, "document after one undo of a drag")
	await settle()


func _reorder() -> void:
	await select(["s"])
	Hands.press_key(window(), KEY_UP, KEY_MASK_ALT)
	expect(names(), ["apex", "s", "B", "pair1", "k1"], "order after Alt and Up")
	undo()
	await settle()


func _drag_row() -> void:
	var from := row_part("pair1", "Message")
	Hands.drag(from, Vector2(0.3, 0.5), row("apex"), Vector2(0.5, 0.03))
	expect(names(), ["pair1", "apex", "B", "s", "k1"], "order after dragging a row to the top")
	await settle()
	undo()
	expect(names(), ["apex", "B", "s", "pair1", "k1"], "order after undoing the drag")
	part("Entries").call(&"scroll_to", "apex")
	await settle()


func _delete() -> void:
	await select(["apex"])
	Hands.press_key(window(), KEY_DELETE)
	var question := dock().get_node("Panel/EntryMenu/Question") as ConfirmationDialog
	expect(question.visible, true, "a question before deleting")
	expect_true(
		question.dialog_text.begins_with("s, pair1 depend on apex"),
		"dependent entries in the question: %s" % question.dialog_text
	)
	await settle()
	press(question.get_ok_button())
	await settle()
	expect(names(), ["B", "s", "pair1", "k1"], "names after deleting")
	expect(
		scene().get_error("s"), "column 8: there is no entry 'apex'", "error of a dependent entry"
	)
	expect(words_of("s"), "column 8: there is no entry 'apex'", "text of a dependent entry")
	undo()
	await settle()
	expect(scene().get_error("s"), "", "error after undo")
