extends MenuButton
## Chooses the kind of object that a click in the view adds.

signal chosen(kind: StringName)

const NewObjects := preload("res://addons/ga_godot/playground/document/new_objects.gd")
const PlaygroundIcons := preload("res://addons/ga_godot/playground/theme/playground_icons.gd")

## Kinds without a position, which a click cannot add.
const WITHOUT_POSITION: Array[StringName] = [&"scalar"]

var _kinds: Array[StringName] = []


func _ready() -> void:
	name = "Adding"
	tooltip_text = "Add objects by clicking in the view."
	theme_type_variation = &"FlatButton"
	for kind in NewObjects.KINDS:
		if not kind in WITHOUT_POSITION:
			_kinds.append(kind)
			get_popup().add_item(NewObjects.TITLES[kind])
	get_popup().index_pressed.connect(func(index: int) -> void: chosen.emit(_kinds[index]))


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree():
		icon = get_theme_icon(&"Add", &"EditorIcons")
		for index in _kinds.size():
			get_popup().set_item_icon(index, PlaygroundIcons.make(_kinds[index], self))
