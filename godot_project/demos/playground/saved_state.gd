extends RefCounted
## The state that persists between sessions: the document with its unsaved changes, and settings of
## the view.

const PlaygroundDocument := preload(
	"res://addons/ga_godot/playground/document/playground_document.gd"
)

const SafeFile := preload("res://addons/ga_godot/playground/document/safe_file.gd")

const SECTION := "playground"

## The file; empty to persist nothing.
var path: String

var _file := ConfigFile.new()


func _init(p_path: String) -> void:
	path = p_path
	if not path.is_empty() and FileAccess.file_exists(path):
		_file.load(path)


func get_setting(key: String, default: Variant) -> Variant:
	return _file.get_value(SECTION, key, default)


func save(document: PlaygroundDocument, settings: Dictionary[String, Variant]) -> void:
	if path.is_empty():
		return
	_file.set_value(SECTION, "path", document.path)
	_file.set_value(SECTION, "saved", document.get_saved_text())
	_file.set_value(SECTION, "document", document.scene.document)
	for key in settings:
		_file.set_value(SECTION, key, settings[key])
	var outcome := SafeFile.save_config(path, _file)
	if outcome != OK:
		push_warning("%s cannot be saved: %s." % [path, error_string(outcome)])


func has_document() -> bool:
	return _file.has_section_key(SECTION, "document")


func restore(document: PlaygroundDocument) -> void:
	if not has_document():
		return
	var scene := GAScene.new()
	scene.document = get_setting("saved", "")
	document.show_scene(scene, get_setting("path", "") as String)
	scene.document = get_setting("document", "")
