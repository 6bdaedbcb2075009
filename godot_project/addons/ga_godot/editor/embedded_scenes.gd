@tool
extends RefCounted
## A GAScene that is a part of a .tscn: it is saved with that, and leaves the dock with it.

const PlaygroundDocument := preload("../playground/document/playground_document.gd")

var _document: PlaygroundDocument


func _init(document: PlaygroundDocument) -> void:
	_document = document


## A .tscn was saved, and with it what it embeds.
func on_scene_saved(path: String) -> void:
	if _document.get_file() == path and _document.is_embedded():
		_document.mark_saved(_document.path)


func on_scene_closed(path: String) -> void:
	if _document.get_file() == path and _document.is_embedded():
		_document.show_scene(GAScene.new(), "")
