@tool
extends "../chapter.gd"
## Saving and opening scenes through the dialogs, invalid files, and the question about unsaved
## changes.

const JSON_FILE := "res://probe_scene.json"
const TRES_FILE := "res://probe_scene.tres"
const BROKEN := """{"format": "ga_godot_scene", "version": 1, "entries": [
	{"name": "A", "expression": "point(1, 2, 3)"}, {"name": 5},
	{"name": "s", "expression": "sphere(A, 1)"}]}"""


func run() -> void:
	await begin_with([])
	Hands.click(part("Objects/sphere"))
	await settle(2)
	expect(file_name().text, "[unsaved]*", "name of a scene that was never saved")
	await _save_and_open(JSON_FILE)
	await _save_and_open(TRES_FILE)
	await _open_broken()
	await _open_others()
	await _ask()


func _save_and_open(path: String) -> void:
	var before := scene().document
	await choose_in_file_menu("Save As...")
	await _give_path(path)
	expect_true(FileAccess.file_exists(path), "the file %s" % path)
	expect(file_name().text, path.get_file(), "name after saving")
	expect(document().get(&"path"), path, "path after saving")
	Hands.click(part("Objects/point"))
	await settle(2)
	expect(file_name().text, path.get_file() + "*", "name after a change")
	await choose_in_file_menu("Save")
	expect(file_name().text, path.get_file(), "name after saving again")
	undo()
	await settle(2)
	await choose_in_file_menu("Save")
	expect(scene().document, before, "document after undoing and saving")
	await choose_in_file_menu("New")
	expect(names(), [], "entries of a new scene")
	expect(_question().visible, false, "a question although everything was saved")
	await choose_in_file_menu("Open...")
	await _give_path(path)
	expect(scene().document, before, "document after opening %s" % path)
	expect(words_of("s1"), "sphere, radius 1, center (0, 0, 0)", "row after opening")
	await choose_in_file_menu("Save")
	expect(scene().document, before, "document after saving what was opened")


## The valid entries are opened, the others reported.
func _open_broken() -> void:
	FileAccess.open("res://broken.json", FileAccess.WRITE).store_string(BROKEN)
	await choose_in_file_menu("Open...")
	await _give_path("res://broken.json")
	expect(names(), ["A", "s"], "entries of a file with a broken one")
	expect_true(
		(
			_toasts().contains("broken.json was only partly read")
			and _toasts().contains("line 2, column 58: entry skipped")
		),
		"the warning about a broken entry: %s" % _toasts()
	)
	expect(document().get(&"path"), "", "path of a partly read file, which must not be overwritten")
	Hands.click(part("Objects/point"))
	await settle(2)
	EditorInterface.save_all_scenes()
	await settle(2)
	expect(
		FileAccess.get_file_as_string("res://broken.json"),
		BROKEN,
		"the broken file after opening it"
	)
	undo()
	await settle(2)


func _open_others() -> void:
	var before := scene().document
	FileAccess.open("res://no_scene.json", FileAccess.WRITE).store_string("[1, 2")
	await choose_in_file_menu("Open...")
	await _give_path("res://no_scene.json")
	expect(scene().document, before, "document after a file that is not JSON")
	expect_true(
		_toasts().contains("no_scene.json is not a playground scene"),
		"the warning about a file that is not JSON: %s" % _toasts()
	)
	ResourceSaver.save(Gradient.new(), "res://gradient.tres")
	await choose_in_file_menu("Open...")
	await _give_path("res://gradient.tres")
	expect(scene().document, before, "document after a file of another type")
	expect_true(
		_toasts().contains("gradient.tres contains a Gradient"),
		"the warning about a file of another type: %s" % _toasts()
	)


func _ask() -> void:
	await begin_with([])
	Hands.click(part("Objects/sphere"))
	await settle(2)
	for item: String in ["New", "Open..."]:
		var before := scene().document
		await choose_in_file_menu(item)
		expect(_question().visible, true, "a question before %s" % item)
		press(_question().get_cancel_button())
		await settle()
		expect(scene().document, before, "document after %s was cancelled" % item)
		expect(_files().visible, false, "the dialog after %s was cancelled" % item)
	await choose_in_file_menu("Open...")
	press(_question().get_ok_button())
	await settle()
	await _give_path(TRES_FILE)
	expect(names(), ["s1"], "entries after discarding and opening")
	Hands.click(part("Objects/circle"))
	await settle(2)
	await choose_in_file_menu("New")
	press(_question().get_ok_button())
	await settle()
	expect(names(), [], "entries after discarding for a new scene")
	await choose_in_file_menu("Open...")
	await _give_path(TRES_FILE)
	expect(names(), ["s1"], "entries after opening again what was changed and discarded")


func _give_path(path: String) -> void:
	expect(_files().visible, true, "the dialog for %s" % path)
	Hands.write_over(_files().get_line_edit(), path.get_file())
	await settle(2)
	Hands.press_key(_files(), KEY_ENTER)
	await settle()
	for asked: ConfirmationDialog in _files().find_children("*", "ConfirmationDialog", true, false):
		if asked.visible:
			press(asked.get_ok_button())
	await settle()


func _files() -> FileDialog:
	return file_menu().get_node("Files")


func _question() -> ConfirmationDialog:
	return file_menu().get_node("Question")


## All messages that the editor shows in its corner.
func _toasts() -> String:
	var texts := PackedStringArray()
	for label: Label in EditorInterface.get_editor_toaster().find_children(
		"*", "Label", true, false
	):
		texts.append(label.text)
	return "\n".join(texts)
