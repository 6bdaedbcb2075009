@tool
extends PopupMenu
## A menu of the examples in the gallery.

## Emitted when the user chooses an example. `scene` is a new copy of it.
signal chosen(scene: GAScene, title: String)
## Emitted when the example cannot be opened. `message` says why.
signal failed(message: String)

const Gallery := preload("../document/gallery.gd")


func _init() -> void:
	name = "Examples"
	var examples := Gallery.list()
	for id in examples.size():
		if Gallery.SECTIONS.has(examples[id]):
			add_separator(Gallery.SECTIONS[examples[id]])
		add_item(Gallery.EXAMPLES[examples[id]], id)
	id_pressed.connect(_on_id_pressed)


func _on_id_pressed(id: int) -> void:
	var example := Gallery.list()[id]
	var scene := Gallery.load_example(example)
	if scene == null:
		failed.emit(Gallery.error_of(example))
	else:
		chosen.emit(scene, Gallery.EXAMPLES[example])
