@tool
extends "../chapter.gd"
## Ctrl+Z with the focus in the dock undoes the playground's last action, whatever else was done in
## the editor since.

const EDITED_SCENE := "res://demos/interpolation/interpolation.tscn"


func run() -> void:
	EditorInterface.open_scene_from_path(EDITED_SCENE)
	await begin_with([])
	await _in_empty_line()
	await _in_row()
	await _after_other_actions()
	await _while_typing()


## In the empty expression line.
func _in_empty_line() -> void:
	Hands.click(line())
	Hands.type(window(), "A = point(1, 2, 3)")
	Hands.press_key(window(), KEY_ENTER)
	await settle(2)
	expect(names(), ["A"], "entries after typing one")
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	expect(names(), [], "entries after Ctrl+Z in the empty line")
	expect(line().text, "", "the line after Ctrl+Z")
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	expect(names(), ["A"], "entries after Ctrl+Shift+Z in the empty line")
	await settle(2)


func _in_row() -> void:
	Hands.click(part("Objects/sphere"))
	await settle(2)
	await select(["A"])
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	expect(names(), ["A"], "entries after Ctrl+Z in a row")
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	expect(names(), ["A", "s1"], "entries after Ctrl+Shift+Z in a row")
	await settle(2)


func _after_other_actions() -> void:
	var root := EditorInterface.get_edited_scene_root()
	var history := plugin.get_undo_redo()
	history.create_action("Rename Root", UndoRedo.MERGE_DISABLE, root)
	history.add_do_property(root, &"editor_description", "done")
	history.add_undo_property(root, &"editor_description", "")
	history.commit_action()
	await select(["A"])
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	expect(names(), ["A"], "entries after Ctrl+Z in the dock, with a newer action of the scene")
	expect(root.editor_description, "done", "the scene after Ctrl+Z in the dock")
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	expect(
		names(),
		["A", "s1"],
		"entries after Ctrl+Shift+Z in the dock, with a newer action of the scene"
	)
	undo()
	expect(root.editor_description, "", "the scene after Ctrl+Z outside of the dock")
	expect(names(), ["A", "s1"], "entries after Ctrl+Z outside of the dock")
	redo()
	await settle(2)
	await select(["A"])
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	expect(names(), [], "entries after undoing all of the playground's actions")
	expect(
		root.editor_description, "done", "the scene after undoing all of the playground's actions"
	)
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	expect(names(), ["A", "s1"], "entries after redoing all")
	undo()
	expect(root.editor_description, "", "the scene after undoing its action")
	await settle(2)


## The edited text is undone first.
func _while_typing() -> void:
	Hands.click(line())
	Hands.type(window(), "sphere(A")
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	expect(names(), ["A", "s1"], "entries after Ctrl+Z in a line that is being typed")
	line().clear()
