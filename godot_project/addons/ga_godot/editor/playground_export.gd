@tool
extends EditorExportPlugin
## Adds the playground to exported games. Its folder has a .gdignore, because the editor would
## report errors in its scripts while the library is missing. The editor does not export JSON files,
## such as the examples, by default.

const FOLDERS: PackedStringArray = [
	"res://addons/ga_godot/playground", "res://addons/ga_godot/gallery"
]
const OPTION := &"ga_godot/include_playground"
const EXCLUDED: PackedStringArray = ["uid", "gdignore"]


func _get_name() -> String:
	return "GAGodotPlayground"


func _supports_platform(_platform: EditorExportPlatform) -> bool:
	return true


func _get_export_options(_platform: EditorExportPlatform) -> Array[Dictionary]:
	return [{"option": {"name": OPTION, "type": TYPE_BOOL}, "default_value": true}]


func _export_begin(
	_features: PackedStringArray, _is_debug: bool, _path: String, _flags: int
) -> void:
	if get_option(OPTION):
		for folder in FOLDERS:
			_add_folder(folder)


func _add_folder(folder: String) -> void:
	for file in DirAccess.get_files_at(folder):
		if not EXCLUDED.has(file.get_extension()):
			var path := folder.path_join(file)
			add_file(path, FileAccess.get_file_as_bytes(path), false)
	for inner in DirAccess.get_directories_at(folder):
		_add_folder(folder.path_join(inner))
