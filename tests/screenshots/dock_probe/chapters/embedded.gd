@tool
extends "../chapter.gd"
## A GAScene embedded in a .tscn: shown for its node, changed in that scene's history, saved with
## it.

const PLACE := "res://probe_embedded.tscn"
const OTHER := "res://demos/interpolation/interpolation.tscn"


func run() -> void:
	_write_scene()
	await begin_with(["k", "5"])
	EditorInterface.open_scene_from_path(PLACE)
	await settle()
	await _show_by_node()
	await _edit_and_undo()
	await _save_and_reload()
	await _switch_tabs()
	await _ask_before_replacing()
	await _close_tab()


func _write_scene() -> void:
	var root := Node3D.new()
	root.name = "Root"
	var node := GANode3D.new()
	node.name = "Drawn"
	node.scene = GAScene.new()
	node.scene.add_entry("A", "point(1, 2, 3)")
	node.entry = &"A"
	root.add_child(node)
	node.owner = root
	var packed := PackedScene.new()
	packed.pack(root)
	expect(ResourceSaver.save(packed, PLACE), OK, "saving a scene with an embedded one")
	root.free()


func _show_by_node() -> void:
	var own := scene()
	Hands.click(part("Objects/circle"))
	await settle(2)
	_select_node()
	await settle()
	expect(scene() == _node().scene, true, "the scene of the selected node in the dock")
	expect(file_name().text, "probe_embedded.tscn", "its name in the dock")
	EditorInterface.get_selection().clear()
	await settle()
	expect(scene() == own, true, "the dock's own scene when no node is selected")
	expect(file_name().text, "[unsaved]*", "its name when no node is selected")
	expect(names(), ["k", "c1"], "its unsaved entries")
	undo()
	await settle(2)
	EditorInterface.edit_resource(_node().scene)
	await settle()
	expect(scene() == _node().scene, true, "the scene that the inspector shows in the dock")


func _edit_and_undo() -> void:
	dock().make_visible()
	await settle()
	Hands.click(part("Objects/sphere"))
	await settle(2)
	expect(names(), ["A", "s1"], "entries of the embedded scene")
	expect_true(
		_history().get_current_action_name().contains("Add s1"),
		"last step of the .tscn: %s" % _history().get_current_action_name()
	)
	expect_true(_history().get_version() > 1, "the .tscn being unsaved")
	undo()
	await settle(2)
	expect(names(), ["A"], "entries after undo")
	redo()
	await settle(2)
	expect(names(), ["A", "s1"], "entries after redo")


func _save_and_reload() -> void:
	expect(file_name().text, "probe_embedded.tscn*", "name with changes")
	await choose_in_file_menu("Save")
	expect(file_name().text, "probe_embedded.tscn", "name after saving")
	expect_true(
		FileAccess.get_file_as_string(PLACE).contains("sphere(point(0, 0, 0), 1)"),
		"the saved .tscn having what was added"
	)
	EditorInterface.reload_scene_from_path(PLACE)
	await settle()
	EditorInterface.edit_resource(_node().scene)
	await settle()
	expect(scene() == _node().scene, true, "the scene of the node after reloading")
	expect(Array(_node().scene.get_names()), ["A", "s1"], "entries after reloading")
	expect(names(), ["A", "s1"], "rows after reloading")


## The dock keeps its scene; actions go to the history of that scene.
func _switch_tabs() -> void:
	var edited := scene()
	EditorInterface.open_scene_from_path(OTHER)
	await settle()
	expect(scene() == edited, true, "the embedded scene while another tab is open")
	Hands.click(part("Objects/plane"))
	await settle(2)
	expect(names(), ["A", "s1", "p1"], "entries changed from another tab")
	await select(["A"])
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)
	await settle(2)
	expect(names(), ["A", "s1"], "entries after Ctrl and Z in the dock, from another tab")
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	await settle(2)
	expect(names(), ["A", "s1", "p1"], "entries after redoing from another tab")
	EditorInterface.open_scene_from_path(PLACE)
	await settle()
	expect(
		Array(_node().scene.get_names()), ["A", "s1", "p1"], "entries of the node after coming back"
	)
	undo()
	await settle(2)
	expect(names(), ["A", "s1"], "entries after undo in the scene's own tab")


## A scene that is opened in the inspector replaces an unsaved one.
func _ask_before_replacing() -> void:
	await begin_with([])
	Hands.click(part("Objects/circle"))
	await settle(2)
	var unsaved := scene()
	EditorInterface.edit_resource(_node().scene)
	await settle()
	expect(scene() == unsaved, true, "an unsaved scene before the question is answered")
	var question := file_menu().get_node("Question") as ConfirmationDialog
	expect(
		question.visible, true, "a question before another scene takes the place of an unsaved one"
	)
	press(question.get_ok_button())
	await settle()
	expect(scene() == _node().scene, true, "the scene after discarding")


func _close_tab() -> void:
	EditorInterface.open_scene_from_path(PLACE)
	EditorInterface.save_scene()
	await settle()
	expect(EditorInterface.close_scene(), OK, "closing the scene")
	await settle()
	expect(names(), [], "entries after the scene that they are in was closed")
	expect(file_name().text, "[unsaved]", "name after that")


func _select_node() -> void:
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(_node())
	EditorInterface.edit_node(_node())


func _node() -> GANode3D:
	return EditorInterface.get_edited_scene_root().get_node(^"Drawn")


func _history() -> UndoRedo:
	return plugin.get_undo_redo().get_history_undo_redo(
		plugin.get_undo_redo().get_object_history_id(EditorInterface.get_edited_scene_root())
	)
