@tool
extends "../chapter.gd"
## Ctrl and Z with the focus in the dock: the playground's last step, whatever else was done in the
## editor since.

const EDITED_SCENE := "res://demos/interpolation/interpolation.tscn"


func read() -> void:
	EditorInterface.open_scene_from_path(EDITED_SCENE)
	await begin_with([])
	await _in_empty_line()
	await _in_row()
	await _after_other_steps()
	await _while_typing()


## Where expressions are typed, once nothing stands there.
func _in_empty_line() -> void:
	Hands.click(line())
	Hands.type(window(), "A = point(1, 2, 3)")
	Hands.press_key(window(), KEY_ENTER)
	await settle(2)
	expect(names(), ["A"], "entries after typing one")
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	expect(names(), [], "entries after Ctrl and Z in the empty line")
	expect(line().text, "", "the line after Ctrl and Z")
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	expect(names(), ["A"], "entries after Ctrl, Shift and Z in the empty line")
	await settle(2)


func _in_row() -> void:
	Hands.click(part("Objects/sphere"))
	await settle(2)
	await select(["A"])
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	expect(names(), ["A"], "entries after Ctrl and Z in a row")
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	expect(names(), ["A", "s1"], "entries after Ctrl, Shift and Z in a row")
	await settle(2)


func _after_other_steps() -> void:
	var root := EditorInterface.get_edited_scene_root()
	var history := plugin.get_undo_redo()
	history.create_action("Rename Root", UndoRedo.MERGE_DISABLE, root)
	history.add_do_property(root, &"editor_description", "done")
	history.add_undo_property(root, &"editor_description", "")
	history.commit_action()
	await select(["A"])
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	expect(names(), ["A"], "entries after Ctrl and Z in the dock, with a newer step of the scene")
	expect(root.editor_description, "done", "the scene after Ctrl and Z in the dock")
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	expect(
		names(),
		["A", "s1"],
		"entries after Ctrl, Shift and Z in the dock, with a newer step of the scene"
	)
	undo()
	expect(root.editor_description, "", "the scene after Ctrl and Z outside of the dock")
	expect(names(), ["A", "s1"], "entries after Ctrl and Z outside of the dock")
	redo()
	await settle(2)
	await select(["A"])
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	expect(names(), [], "entries after undoing all of the playground's steps")
	expect(root.editor_description, "done", "the scene after undoing all of the playground's steps")
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	expect(names(), ["A", "s1"], "entries after redoing all")
	undo()
	expect(root.editor_description, "", "the scene after undoing its step")
	await settle(2)


## What is typed is undone first.
func _while_typing() -> void:
	Hands.click(line())
	Hands.type(window(), "sphere(A")
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	expect(names(), ["A", "s1"], "entries after Ctrl and Z in a line that is being typed")
	line().clear()
