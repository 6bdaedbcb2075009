@tool
extends VBoxContainer
## Selects the start and end pose, and shows problems with them.

const EntryList := preload("../entries/entry_list.gd")
const PlaygroundIcons := preload("../theme/playground_icons.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")
const InterpolationLab := preload("interpolation_lab.gd")

const CHOICE_WIDTH := 64.0
const DIMMED := Color(1, 1, 1, 0.65)

var _lab: InterpolationLab
var _list: EntryList
var _from := OptionButton.new()
var _to := OptionButton.new()
var _swap := Button.new()
var _use_selection := Button.new()
var _message := Label.new()


func _init(lab: InterpolationLab, list: EntryList) -> void:
	name = "Ends"
	_lab = lab
	_list = list
	var line := HBoxContainer.new()
	add_child(line)
	_prepare_choice(_from, "From", "The pose at t = 0.")
	_prepare_choice(_to, "To", "The pose at t = 1.")
	_prepare_button(_swap, "Swap", "Swap the two poses.", _on_swap_pressed)
	_prepare_button(_use_selection, "UseSelection", "", _on_use_selection_pressed)
	for part: Control in [_from, _swap, _to, _use_selection]:
		line.add_child(part)
	_message.name = "Message"
	_message.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	add_child(_message)
	_list.selection_changed.connect(_show_selection)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree():
		_swap.icon = PlaygroundIcons.make(&"swap", self)
		_use_selection.icon = PlaygroundIcons.make(&"pick", self)


func refresh() -> void:
	var names := _lab.poses.get_candidates()
	_fill(_from, names, _lab.poses.from_name)
	_fill(_to, names, _lab.poses.to_name)
	_swap.disabled = _lab.poses.from_name.is_empty() or _lab.poses.to_name.is_empty()
	_show_selection()
	var error := _lab.poses.error
	_message.text = error if not error.is_empty() else _lab.poses.notice
	_message.visible = not _message.text.is_empty()
	# Having too few poses is not an error.
	if error.is_empty() or names.size() < 2:
		_message.remove_theme_color_override(&"font_color")
		_message.modulate = DIMMED
	else:
		_message.add_theme_color_override(&"font_color", get_theme_color(&"error_color", &"Editor"))
		_message.modulate = Color.WHITE


func _prepare_choice(choice: OptionButton, title: String, hint: String) -> void:
	choice.name = title
	choice.tooltip_text = hint
	choice.fit_to_longest_item = false
	choice.text_overrun_behavior = TextServer.OVERRUN_TRIM_ELLIPSIS
	choice.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	choice.custom_minimum_size.x = CHOICE_WIDTH * PlaygroundStyle.scale()
	choice.item_selected.connect(
		func(_index: int) -> void: _lab.choose(_chosen(_from), _chosen(_to))
	)


func _prepare_button(button: Button, title: String, hint: String, act: Callable) -> void:
	button.name = title
	button.tooltip_text = hint
	button.theme_type_variation = &"FlatButton"
	button.focus_mode = Control.FOCUS_NONE
	button.pressed.connect(act)


# A chosen entry that cannot be used is listed too, but disabled.
func _fill(choice: OptionButton, names: PackedStringArray, chosen: String) -> void:
	var shown := names.duplicate()
	if not chosen.is_empty() and not shown.has(chosen):
		shown.append(chosen)
	for index in shown.size():
		if index == choice.item_count:
			choice.add_item(shown[index])
		elif choice.get_item_text(index) != shown[index]:
			choice.set_item_text(index, shown[index])
		choice.set_item_disabled(index, not names.has(shown[index]))
	while choice.item_count > shown.size():
		choice.remove_item(choice.item_count - 1)
	choice.selected = shown.find(chosen)
	choice.disabled = names.is_empty()


func _chosen(choice: OptionButton) -> String:
	return choice.get_item_text(choice.selected) if choice.selected >= 0 else ""


func _show_selection() -> void:
	var pair := _selected_pair()
	_use_selection.disabled = pair.is_empty()
	_use_selection.tooltip_text = (
		"Interpolate between the selected entries, from %s to %s." % [pair[0], pair[1]]
		if not pair.is_empty()
		else "Interpolate between the selected motors. Ctrl+click to select two."
	)


func _selected_pair() -> PackedStringArray:
	var motors := PackedStringArray(Array(_list.selection).filter(_lab.poses.is_candidate))
	return motors if motors.size() == 2 else PackedStringArray()


func _on_use_selection_pressed() -> void:
	var pair := _selected_pair()
	if not pair.is_empty():
		_lab.choose(pair[0], pair[1])


func _on_swap_pressed() -> void:
	_lab.choose(_lab.poses.to_name, _lab.poses.from_name)
