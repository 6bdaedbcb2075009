@tool
extends "../chapter.gd"
## After a restart of the editor, everything is as leaving.gd left it.

const PLACE := "res://probe_left.tres"


func run() -> void:
	dock().make_visible()
	await settle()
	expect(names(), ["A", "k", "s1"], "entries after a restart of the editor")
	expect(scene().get_entry_attribute("A", "visible"), false, "what was hidden before the restart")
	expect(words_of("s1"), "sphere, radius 1, center (0, 0, 0)", "row after a restart")
	expect(file_name().text, "probe_left.tres*", "name after a restart")
	expect(document().get(&"path"), PLACE, "path after a restart")
	expect(
		FileAccess.get_file_as_string(PLACE).contains("sphere"),
		false,
		"unsaved changes in the file"
	)
	await choose_in_file_menu("Save")
	expect(file_name().text, "probe_left.tres", "name after saving")
	expect(
		FileAccess.get_file_as_string(PLACE).contains("sphere"), true, "saved changes in the file"
	)
