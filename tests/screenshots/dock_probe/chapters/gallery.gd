@tool
extends "../chapter.gd"
## Opens an example and exports a picture of it.

const EXAMPLE := "Two spheres, three spheres"
const OTHER := "Circle through three points"
const PICTURE := "res://probe_picture.png"


func run() -> void:
	await begin_with([])
	await _open_example()
	await _keep_changes()
	await _export()


func _open_example() -> void:
	Hands.click(dock().find_child("ExamplesButton", true, false) as Control)
	expect_true(_examples().visible, "the menu of examples")
	choose(_examples(), EXAMPLE)
	await settle()
	expect(names().slice(0, 4), ["A", "B", "C", "AB"], "entries of an example")
	expect(
		words_of("A"),
		"sphere, radius 1.55, center (-1.1, 0.7, 0.4)",
		"description of an example's entry"
	)
	expect_true(_description().visible, "the description")
	expect((_description().find_child("Title", true, false) as Label).text, EXAMPLE, "its title")
	Hands.click(_description().find_child("Close", true, false) as Control)
	expect_true(not _description().visible, "the description being hidden after a click")


## Another example replaces a changed scene only after a question.
func _keep_changes() -> void:
	Hands.click(part("Objects/point"))
	await settle()
	var changed := scene().document
	choose(_examples(), OTHER)
	await settle()
	var question := file_menu().get_node(^"Question") as ConfirmationDialog
	expect_true(question.visible, "a question before an example replaces changes")
	press(question.get_cancel_button())
	await settle()
	expect(scene().document, changed, "document after Cancel")
	undo()


func _export() -> void:
	RenderingServer.render_loop_enabled = true
	await choose_in_file_menu("Export Picture...")
	var dialog := dock().find_child("PictureDialog", true, false) as ConfirmationDialog
	expect_true(dialog.visible, "the picture dialog")
	var sizes := dialog.find_child("Size", true, false) as OptionButton
	sizes.select(2)
	sizes.item_selected.emit(2)
	var path := dialog.find_child("Path", true, false) as LineEdit
	path.text = "res://no_folder/picture.png"
	press(dialog.get_ok_button())
	await settle(20)
	var problem := dialog.find_child("Error", true, false) as Label
	expect_true(
		dialog.visible and problem.visible and problem.text.contains("no_folder"),
		"error about the file: %s" % problem.text
	)
	path.text = PICTURE
	press(dialog.get_ok_button())
	await settle(20)
	expect_true(not dialog.visible, "the dialog being closed: %s" % problem.text)
	var picture := Image.load_from_file(PICTURE)
	expect(
		picture.get_size() if picture != null else Vector2i(),
		Vector2i(1920, 1080),
		"size of the picture"
	)
	expect_true(picture != null and _color_count(picture) > 50, "a picture that is not empty")
	RenderingServer.render_loop_enabled = false


func _color_count(image: Image) -> int:
	var small := image.duplicate() as Image
	small.resize(192, 108, Image.INTERPOLATE_NEAREST)
	var colors: Dictionary[Color, bool] = {}
	for y in small.get_height():
		for x in small.get_width():
			colors[small.get_pixel(x, y)] = true
	return colors.size()


func _examples() -> PopupMenu:
	return dock().find_child("ExamplesButton", true, false).get_child(0) as PopupMenu


func _description() -> Control:
	return dock().find_child("Description", true, false) as Control
