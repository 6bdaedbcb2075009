@tool
extends EditorExportPlugin
## Adds the playground and its examples to exported games that use it, and leaves out the plugin.
##
## The folder of the playground has a .gdignore, because the editor would report errors in its
## scripts while the library is missing; so the editor itself exports none of them.

const FOLDERS: PackedStringArray = [
	"res://addons/ga_godot/playground", "res://addons/ga_godot/gallery"
]
const PLUGIN := "res://addons/ga_godot/plugin.gd"
const OPTION := &"ga_godot/include_playground"
const EXCLUDED: PackedStringArray = ["uid", "gdignore"]

var _is_added := false


func _get_name() -> String:
	return "GAGodotPlayground"


func _supports_platform(_platform: EditorExportPlatform) -> bool:
	return true


func _get_export_options(_platform: EditorExportPlatform) -> Array[Dictionary]:
	return [{"option": {"name": OPTION, "type": TYPE_BOOL}, "default_value": true}]


func _export_begin(
	_features: PackedStringArray, _is_debug: bool, _path: String, _flags: int
) -> void:
	_is_added = false


func _export_file(path: String, _type: String, _features: PackedStringArray) -> void:
	if path == PLUGIN or _names_playground(path):
		skip()
	elif not _is_added and get_option(OPTION) and _uses_playground(path):
		_is_added = true
		for folder in FOLDERS:
			_add_folder(folder)


## Whether an exported script, scene or resource names a file of the playground.
func _uses_playground(path: String) -> bool:
	if path.get_extension() == "gd":
		return _names_playground(FileAccess.get_file_as_string(path))
	for dependency in ResourceLoader.get_dependencies(path):
		if _names_playground(dependency):
			return true
	return false


func _names_playground(text: String) -> bool:
	for folder in FOLDERS:
		if text.contains(folder + "/"):
			return true
	return false


func _add_folder(folder: String) -> void:
	for file in DirAccess.get_files_at(folder):
		if not EXCLUDED.has(file.get_extension()):
			var path := folder.path_join(file)
			add_file(path, FileAccess.get_file_as_bytes(path), false)
	for inner in DirAccess.get_directories_at(folder):
		_add_folder(folder.path_join(inner))
