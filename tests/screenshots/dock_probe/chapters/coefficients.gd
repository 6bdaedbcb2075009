@tool
extends "../chapter.gd"
## The 32 coefficients of the selected entry, typed and dragged, in both bases.


func run() -> void:
	await begin_with(["B", "point(0, 4, 0)", "C", "point(1, 0, 0)", "pair1", "join(B, C)"])
	await select(["B"])
	coefficients().expand()
	await settle()
	await _type_number()
	await _drag_number()
	await _null_basis()
	await _dependent()
	coefficients().fold()


func _type_number() -> void:
	var before := scene().document
	expect(number("e1").read_only, false, "a free object being read-only")
	expect(number("e2").value, 4.0, "e2 of B")
	Hands.click(number("e1"))
	await settle()
	var edit := window().gui_get_focus_owner() as LineEdit
	expect_true(edit != null, "a text field for the number")
	if edit != null:
		Hands.press_key(edit.get_viewport(), KEY_A, KEY_MASK_CTRL)
		Hands.type(edit.get_viewport(), "2.5")
		Hands.press_key(edit.get_viewport(), KEY_ENTER)
	await settle()
	expect(scene().get_value("B").coefficients[1], 2.5, "e1 after typing it")
	undo()
	expect(scene().document, before, "document after undoing a coefficient")
	await settle(2)


func _drag_number() -> void:
	var before := scene().document
	var changes := [0]
	var count := func() -> void: changes[0] += 1
	scene().changed.connect(count)
	Hands.drag_with(number("e1"), 40)
	scene().changed.disconnect(count)
	await settle()
	expect_true(changes[0] > 3, "changes while dragging a coefficient: %d" % changes[0])
	expect_true(scene().get_value("B").coefficients[1] != 0.0, "e1 after dragging it")
	undo()
	expect(scene().document, before, "document after one undo of a dragged coefficient")
	await settle(2)


## B = 4 e2 + eo + 8 einf.
func _null_basis() -> void:
	var before := scene().document
	var basis := coefficients().find_child("Basis", true, false) as OptionButton
	basis.select(1)
	basis.item_selected.emit(1)
	expect(number("e4").label, "e∞", "name of a blade in the null basis")
	expect(number("e4").value, 8.0, "coefficient of einf")
	expect(number("e5").value, 1.0, "coefficient of eo")
	number("e4").value = 2.0
	expect(scene().get_value("B").coefficients[4], 1.5, "e4 with 2 einf and 1 eo")
	expect(scene().get_value("B").coefficients[5], 2.5, "e5 with 2 einf and 1 eo")
	expect(number("e5").value, 1.0, "coefficient of eo after editing that of einf")
	undo()
	expect(scene().document, before, "document after undoing in the null basis")
	basis.select(0)
	basis.item_selected.emit(0)
	await settle(2)


func _dependent() -> void:
	await select(["pair1"])
	expect(number("e1").read_only, true, "a dependent entry being read-only")
	await select(["B"])
	expect(number("e1").read_only, false, "a free object being read-only again")
