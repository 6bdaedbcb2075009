@tool
extends "../playground/playground_host.gd"
## Hosts the panel in the editor.

const EditorHistory := preload("editor_history.gd")
const EditorNumberField := preload("editor_number_field.gd")
const NodeCreation := preload("node_creation.gd")

const DIALOG_CLASS := &"EditorFileDialog"

var _nodes: NodeCreation


func _init(undo_redo: EditorUndoRedoManager) -> void:
	history = EditorHistory.new(undo_redo)
	_nodes = NodeCreation.new(undo_redo)


func make_number_field(step: float) -> NumberField:
	return EditorNumberField.new(step)


func make_file_dialog() -> FileDialog:
	# Before Godot 4.6, EditorFileDialog is not derived from FileDialog.
	var is_derived := ClassDB.is_parent_class(DIALOG_CLASS, &"FileDialog")
	var files: FileDialog = ClassDB.instantiate(DIALOG_CLASS) if is_derived else FileDialog.new()
	files.access = FileDialog.ACCESS_RESOURCES
	return files


func warn(message: String) -> void:
	EditorInterface.get_editor_toaster().push_toast(
		"GA Playground: " + message, EditorToaster.SEVERITY_WARNING
	)


func on_file_written(path: String) -> void:
	EditorInterface.get_resource_filesystem().update_file(path)


func save_containing_scene(file: String) -> void:
	var root := EditorInterface.get_edited_scene_root()
	if root != null and root.scene_file_path == file:
		EditorInterface.save_scene()
	else:
		warn("The scene is embedded in %s. Open that file in a tab to save it." % file)


func can_create_nodes() -> bool:
	return _nodes.is_possible()


func create_node(scene: GAScene, entry: String) -> void:
	_nodes.create(scene, entry)


## The view of the first 3D viewport. The editor does not expose the pivot of its camera, so the
## origin is used.
func make_view_point() -> ViewPoint:
	var camera := EditorInterface.get_editor_viewport_3d().get_camera_3d()
	return ViewPoint.of_camera(camera, camera.global_position.length()) if camera != null else null


func get_view_size() -> Vector2i:
	return EditorInterface.get_editor_viewport_3d().size
