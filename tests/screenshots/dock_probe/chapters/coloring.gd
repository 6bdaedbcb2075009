@tool
extends "../chapter.gd"
## The color picker of an entry: a choice is one action in the history.


func run() -> void:
	await begin_with(["A", "point(0, 0, 0)"])
	var before := scene().document
	var swatch := row_part("A", "Color") as ColorPickerButton
	Hands.click(swatch)
	await settle()
	expect(swatch.get_popup().visible, true, "the picker after a click on the color")
	var text := _find_text(swatch.get_picker())
	for color: String in ["ff0000", "00ff00", "22cc44"]:
		Hands.write_over(text, color)
		Hands.press_key(text.get_viewport(), KEY_ENTER)
		await settle(2)
		expect(scene().get_entry_attribute("A", "color"), "#" + color, "color while it is chosen")
	swatch.get_popup().hide()
	await settle(2)
	var after := scene().document
	undo()
	expect(scene().document, before, "document after one undo of three colors")
	redo()
	expect(scene().document, after, "document after redoing the choice")
	expect(swatch.color.to_html(false), "22cc44", "color of the swatch")
	Hands.click(swatch)
	await settle()
	swatch.get_popup().hide()
	await settle(2)
	undo()
	expect(
		scene().document,
		before,
		"document after undo, with a picker opened in between without a choice"
	)


# The picker's text field for hexadecimal colors.
func _find_text(picker: ColorPicker) -> LineEdit:
	for edit: LineEdit in picker.find_children("*", "LineEdit", true, false):
		if (
			edit.is_visible_in_tree()
			and edit.text.length() >= 6
			and not edit.get_parent() is SpinBox
		):
			return edit
	return null
