@tool
extends "first_look.gd"
## The steps of docs/guides/playground.md: its quick start, and what it says about nodes and about
## the interpolation of two motors.


func run() -> void:
	dock().make_visible()
	await begin_with([])
	_read_tooltips()
	await _add_points()
	await _type_circle()
	await _meet()
	await _change()
	await save_picture("editor_playground")
	await _undo_all()
	await _create_node()
	await _interpolate()


func _read_tooltips() -> void:
	for row: String in ["Objects", "Combinations"]:
		for found in part(row).find_children("*", "Button", true, false):
			expect_true(
				not (found as Button).tooltip_text.is_empty(), "the text of %s" % found.name
			)


func _add_points() -> void:
	for click in 3:
		Hands.click(part("Objects/point"))
	expect(names(), ["A", "B", "C"], "points by three clicks")
	await settle()
	await _write("C", "point(0, 1.5, 0)")


func _type_circle() -> void:
	Hands.click(line())
	Hands.type(window(), "k = A ^ B ^ C")
	await settle()
	expect_true(typed_words().text.begins_with("circle, radius"), typed_words().text)
	Hands.press_key(window(), KEY_ENTER)
	await settle()
	expect(names(), ["A", "B", "C", "k"], "entries after typing")


func _meet() -> void:
	expect(button("meet").disabled, true, "Meet being disabled without two entries")
	Hands.click(part("Objects/sphere"))
	await settle()
	expect(names(), ["A", "B", "C", "k", "s1"], "entries after adding a sphere")
	await select(["s1", "k"])
	expect(button("meet").disabled, false, "Meet being disabled")
	Hands.click(button("meet"))
	await settle()
	expect_true(words_of(_last()).begins_with("point pair"), words_of(_last()))


func _change() -> void:
	var before := words_of(_last())
	await _write("C", "point(0, 1.2, 0)")
	expect_true(words_of(_last()) != before, "the pair following the point: %s" % words_of(_last()))
	await _write("s1", "sphere(0, 0, 9, 1)")
	expect_true(words_of(_last()).begins_with("imaginary point pair"), words_of(_last()))


func _undo_all() -> void:
	for action in 8:
		undo()
		await settle(2)
	expect(names(), ["A"], "entries after undoing all but the first action")
	undo()
	await settle(2)
	expect(names(), [], "entries after undoing all actions")


func _create_node() -> void:
	await begin_with(["ball", "sphere(0, 1, 0, 2)"])
	await choose_for_entry("ball", "Create Node")
	await settle()
	var node := EditorInterface.get_edited_scene_root().get_node_or_null(^"ball") as GANode3D
	expect_true(node != null, "a node in the open scene")
	if node != null:
		expect(node.describe(), "sphere, radius 2, center (0, 1, 0)", "what it draws")


func _interpolate() -> void:
	await begin_with([])
	Hands.click(part("Objects/motor"))
	Hands.click(part("Objects/motor"))
	await settle()
	var lab := dock().find_child("Interpolation", true, false) as FoldPanel
	lab.expand()
	await settle()
	var add := lab.find_child("AddEntry", true, false) as MenuButton
	add.get_popup().id_pressed.emit(MultivectorLerp.SCREW)
	await settle()
	expect(names(), ["m1", "m2", "t", "m3"], "entries after Add as Entry")
	expect(scene().get_expression("m3"), "interpolate_screw(m1, m2, t)", "the entry")
	await save_picture("editor_interpolation")


func _write(entry: String, expression: String) -> void:
	part("Entries").call(&"scroll_to", entry)
	await settle(2)
	Hands.write_over(row_part(entry, "Expression") as LineEdit, expression)
	Hands.press_key(window(), KEY_ENTER)
	await settle()
	expect(scene().get_expression(entry), expression, "expression of %s" % entry)


func _last() -> String:
	return names()[-1]


func button(title: String) -> Button:
	return part("Combinations/%s" % title) as Button
