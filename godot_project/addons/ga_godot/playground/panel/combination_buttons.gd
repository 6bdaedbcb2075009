@tool
extends HFlowContainer
## Buttons that combine two selected entries.

signal added(entry: String)

const EntryEdits := preload("../document/entry_edits.gd")
const EntryList := preload("../entries/entry_list.gd")
const NarrowButton := preload("narrow_button.gd")
const PlaygroundIcons := preload("../theme/playground_icons.gd")

## %s, %s: the entries in the order of selection.
const TITLES: Dictionary[StringName, String] = {
	&"join": "Join %s and %s",
	&"meet": "Meet %s and %s",
	&"intersect": "Intersect %s and %s, converting duals (IPNS) to OPNS first",
	&"project": "Project %s onto %s",
	&"reflect": "Reflect %s in %s",
	&"move": "Apply a motor: %s and %s, one of which must be the motor",
}

var _edits: EntryEdits
var _list: EntryList


func _init(edits: EntryEdits, list: EntryList) -> void:
	name = "Combinations"
	_edits = edits
	_list = list
	add_theme_constant_override(&"h_separation", 0)
	add_theme_constant_override(&"v_separation", 0)
	for operation in EntryEdits.COMBINATIONS:
		var button := Button.new()
		button.name = operation
		button.theme_type_variation = &"FlatButton"
		button.focus_mode = Control.FOCUS_NONE
		button.pressed.connect(_on_pressed.bind(operation))
		add_child(button)
	_list.selection_changed.connect(_show_selection)
	_show_selection()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree():
		for button: Button in get_children():
			button.icon = PlaygroundIcons.make(button.name, self)
			NarrowButton.apply(button)


func _show_selection() -> void:
	var chosen := _list.selection
	for operation in EntryEdits.COMBINATIONS:
		var button: Button = get_node(String(operation))
		var is_pair := chosen.size() == 2
		button.disabled = (
			not is_pair or _edits.combination(operation, chosen[0], chosen[1]).is_empty()
		)
		var title := (
			TITLES[operation] % ([chosen[0], chosen[1]] if is_pair else ["one entry", "another"])
		)
		button.tooltip_text = (
			title + "."
			if is_pair
			else "%s. Click the first entry, then Ctrl+click the second." % title
		)


func _on_pressed(operation: StringName) -> void:
	added.emit(_edits.combine(operation, _list.selection[0], _list.selection[1]))
