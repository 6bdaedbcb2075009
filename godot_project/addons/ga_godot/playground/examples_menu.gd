@tool
extends PopupMenu
## The gallery's examples by their titles, as a menu or a submenu.

const Gallery := preload("gallery.gd")

## A fresh copy of an example.
signal chosen(scene: GAScene, title: String)
## An example cannot be opened: why.
signal failed(words: String)


func _init() -> void:
	name = "Examples"
	for example in Gallery.list():
		add_item(Gallery.EXAMPLES[example])
	index_pressed.connect(_on_index_pressed)


func _on_index_pressed(index: int) -> void:
	var example := Gallery.list()[index]
	var scene := Gallery.load_example(example)
	if scene == null:
		failed.emit(Gallery.error_of(example))
	else:
		chosen.emit(scene, Gallery.EXAMPLES[example])
