@tool
extends "../chapter.gd"
## The dock: floating, moving, closing, opening, disabling the plugin; and creating nodes of
## entries.

const EDITED_SCENE := "res://demos/interpolation/interpolation.tscn"


func run() -> void:
	await begin_with(["s", "sphere(point(0, 0, 0), 2)"])
	await _float()
	await _close()
	await _move()
	await _restart_plugin()
	await _create_node()


func _float() -> void:
	await choose_in_tab_menu("Make Floating")
	expect_true(dock().get_window() != plugin.get_window(), "a window of its own")
	var before := scene().document
	Hands.click(part("Objects/sphere"))
	expect(
		scene().get_value(names()[-1]).classify()["kind"],
		&"sphere",
		"kind of the object added in the window"
	)
	undo()
	await settle(2)
	expect(scene().document, before, "document after undoing in the window")
	dock().get_window().size = Vector2i(600, 500)
	await settle()
	dock().get_window().close_requested.emit()
	await settle()
	expect_true(dock().get_window() == plugin.get_window(), "the dock back in the editor's window")


func _close() -> void:
	dock().close()
	await settle()
	dock().open()
	dock().make_visible()
	await settle()
	expect(words_of("s"), "sphere, radius 2, center (0, 0, 0)", "row after closing and opening")


## Moves the dock to slots on the left and back.
func _move() -> void:
	var home := dock().get_parent()
	for slot: EditorDock.DockSlot in [
		EditorDock.DOCK_SLOT_LEFT_BL, EditorDock.DOCK_SLOT_LEFT_UR, EditorDock.DOCK_SLOT_RIGHT_UL
	]:
		dock().close()
		dock().default_slot = slot
		dock().open()
		dock().make_visible()
		await settle()
		expect(words_of("s"), "sphere, radius 2, center (0, 0, 0)", "row in slot %d" % slot)
	expect_true(dock().get_parent() == home, "the dock back in its slot")


func _restart_plugin() -> void:
	Hands.click(part("Objects/point"))
	await settle(2)
	var before := scene().document
	EditorInterface.set_plugin_enabled("ga_godot", false)
	await settle()
	expect_true(dock() == null, "no dock without the plugin")
	# The playground's actions are still in the history.
	for step in 3:
		Hands.press_key(plugin.get_window(), KEY_Z, KEY_MASK_CTRL)
	for step in 3:
		Hands.press_key(plugin.get_window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	EditorInterface.set_plugin_enabled("ga_godot", true)
	await settle()
	dock().make_visible()
	await settle()
	expect(scene().document, before, "document after the plugin was off and on")
	for step in 3:
		undo()
	expect(
		words_of("s"),
		"sphere, radius 2, center (0, 0, 0)",
		"row after undoing steps from before the plugin was off"
	)
	Hands.click(part("Objects/plane"))
	expect(names()[-1], "p1", "a plane after all that")
	undo()
	expect(scene().document, before, "document after undoing it")


## Creates a node by the menu of an entry.
func _create_node() -> void:
	EditorInterface.open_scene_from_path(EDITED_SCENE)
	await settle()
	var root := EditorInterface.get_edited_scene_root()
	await choose_for_entry("s", "Create Node")
	var node := root.get_node_or_null(^"s")
	expect_true(
		node != null and node.owner == root and node.get(&"scene") == scene(),
		"a node that follows the entry"
	)
	await settle()
	expect(
		_excluded(), PackedStringArray(["s"]), "entries that the dock does not draw, as a node does"
	)
	undo()
	expect(root.has_node(^"s"), false, "the node after undo")
	await settle()
	expect(
		_excluded(),
		PackedStringArray(),
		"entries that the dock does not draw once the node is removed"
	)


func _excluded() -> PackedStringArray:
	return plugin.get_tree().root.find_child("ViewportTool", true, false).get_child(0).get(
		&"excluded"
	)
