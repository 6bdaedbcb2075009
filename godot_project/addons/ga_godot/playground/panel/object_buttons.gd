@tool
extends HFlowContainer
## One button for each kind of object to add, and a toggle to add its dual instead.

signal added(entry: String)

const EntryEdits := preload("../document/entry_edits.gd")
const NewObjects := preload("../document/new_objects.gd")
const NarrowButton := preload("narrow_button.gd")
const PlaygroundIcons := preload("../theme/playground_icons.gd")

var _edits: EntryEdits
var _dual := Button.new()


func _init(edits: EntryEdits) -> void:
	name = "Objects"
	_edits = edits
	add_theme_constant_override(&"h_separation", 0)
	add_theme_constant_override(&"v_separation", 0)
	for kind in NewObjects.KINDS:
		var button := Button.new()
		button.name = kind
		button.pressed.connect(_on_pressed.bind(kind))
		add_child(button)
	_dual.name = &"dual"
	_dual.toggle_mode = true
	_dual.toggled.connect(func(_on: bool) -> void: _show_titles())
	add_child(_dual)
	_show_titles()
	for button: Button in get_children():
		button.theme_type_variation = &"FlatButton"
		button.focus_mode = Control.FOCUS_NONE


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree():
		for button: Button in get_children():
			button.icon = PlaygroundIcons.make(button.name, self)
			NarrowButton.apply(button)


func _show_titles() -> void:
	for kind in NewObjects.KINDS:
		var button: Button = get_node(String(kind))
		button.tooltip_text = (
			"Add a %s%s."
			% [
				"dual " if NewObjects.is_dual(kind, _dual.button_pressed) else "",
				NewObjects.TITLES[kind].to_lower()
			]
		)
	_dual.tooltip_text = "Add objects as duals (IPNS)."


func _on_pressed(kind: StringName) -> void:
	added.emit(_edits.add_object(kind, _dual.button_pressed))
