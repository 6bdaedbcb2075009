@tool
extends RefCounted
## Adds GANode3D nodes, which draw entries, to the edited scene.

const NODE_CLASS := &"GANode3D"

var _undo_redo: EditorUndoRedoManager


func _init(undo_redo: EditorUndoRedoManager) -> void:
	_undo_redo = undo_redo


func is_possible() -> bool:
	return ClassDB.class_exists(NODE_CLASS) and EditorInterface.get_edited_scene_root() != null


## Adds a node that follows the entry as a child of the scene's root.
func create(scene: GAScene, entry: String) -> void:
	var root := EditorInterface.get_edited_scene_root()
	var node: Node3D = ClassDB.instantiate(NODE_CLASS)
	node.name = entry
	node.set(&"scene", scene)
	node.set(&"entry", StringName(entry))
	node.set(&"ipns", scene.get_entry_attribute(entry, "ipns"))
	node.set(&"show_label", scene.get_entry_attribute(entry, "label"))
	var color: String = scene.get_entry_attribute(entry, "color")
	if not color.is_empty():
		node.set(&"color", Color.from_string(color, Color.WHITE))
	_undo_redo.create_action("Create Node for %s" % entry, UndoRedo.MERGE_DISABLE, root)
	_undo_redo.add_do_method(root, &"add_child", node, true)
	_undo_redo.add_do_property(node, &"owner", root)
	_undo_redo.add_do_reference(node)
	_undo_redo.add_undo_method(root, &"remove_child", node)
	_undo_redo.commit_action()
