@tool
extends RefCounted
## Keeps the dock consistent with the .tscn that its GAScene is embedded in: saving the .tscn marks
## the GAScene as saved, and closing the .tscn removes the GAScene from the dock.

const PlaygroundDocument := preload("../playground/document/playground_document.gd")

var _document: PlaygroundDocument


func _init(document: PlaygroundDocument) -> void:
	_document = document


## Call this when the editor has saved a .tscn with its embedded resources.
func on_scene_saved(path: String) -> void:
	if _document.get_file() == path and _document.is_embedded():
		_document.mark_saved(_document.path)


func on_scene_closed(path: String) -> void:
	if _document.get_file() == path and _document.is_embedded():
		_document.show_scene(GAScene.new(), "")
