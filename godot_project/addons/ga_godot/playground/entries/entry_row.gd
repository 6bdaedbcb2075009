@tool
extends PanelContainer
## One row of the entry list: color, name, expression, visibility, label, and the description of the
## value or the error.

## Emitted when the left mouse button is pressed on the row. If `adding`, the click adds the entry
## to the selection.
signal pressed(row: Control, adding: bool)
signal menu_requested(row: Control)

enum Drop { NONE, ABOVE, BELOW }

const PlaygroundDocument := preload("../document/playground_document.gd")
const EntryEdits := preload("../document/entry_edits.gd")
const PlaygroundIcons := preload("../theme/playground_icons.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")
const ValueSlider := preload("value_slider.gd")
const ColorSwatch := preload("color_swatch.gd")

const NAME_WIDTH := 30.0
## Distance between the edge of a button and its icon, in pixels.
const BUTTON_MARGIN := 4.0
const DROP_LINE := 2.0
const DIMMED := Color(1, 1, 1, 0.65)

var entry := ""
var selected := false:
	set = set_selected
## Where a line marks the drop position of a dragged row.
var drop_side := Drop.NONE:
	set = set_drop_side

var _document: PlaygroundDocument
var _edits: EntryEdits
var _swatch: ColorSwatch
var _name := LineEdit.new()
var _equals := Label.new()
var _expression := LineEdit.new()
var _eye := Button.new()
var _label_toggle := Button.new()
var _menu := Button.new()
var _error_icon := TextureRect.new()
var _message := Label.new()
var _slider: ValueSlider
var _label_icon: Texture2D
var _label_icon_on: Texture2D
var _is_styling := false
# The displayed values, by which refresh() detects changes.
var _shown_expression := ""
var _shown_attributes := {}


func _init(document: PlaygroundDocument, edits: EntryEdits) -> void:
	_document = document
	_edits = edits
	_swatch = ColorSwatch.new(document)
	_slider = ValueSlider.new(document)
	mouse_filter = Control.MOUSE_FILTER_STOP
	focus_mode = Control.FOCUS_CLICK
	var lines := VBoxContainer.new()
	lines.mouse_filter = Control.MOUSE_FILTER_PASS
	lines.add_theme_constant_override(&"separation", 0)
	add_child(lines)
	var line := HBoxContainer.new()
	line.mouse_filter = Control.MOUSE_FILTER_PASS
	line.add_theme_constant_override(&"separation", roundi(2 * PlaygroundStyle.scale()))
	lines.add_child(line)
	_prepare_texts()
	_prepare_buttons()
	for part: Control in [_swatch, _name, _equals, _expression]:
		line.add_child(part)
	lines.add_child(_make_slider_line())
	var message_line := HBoxContainer.new()
	message_line.mouse_filter = Control.MOUSE_FILTER_PASS
	message_line.add_theme_constant_override(&"separation", roundi(2 * PlaygroundStyle.scale()))
	for part: Control in [_error_icon, _message, _eye, _label_toggle, _menu]:
		message_line.add_child(part)
	lines.add_child(message_line)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree() and not _is_styling:
		_label_icon = PlaygroundIcons.make(&"label", self)
		_label_icon_on = PlaygroundIcons.make(&"label", self, &"accent_color")
		_message.add_theme_stylebox_override(&"normal", _message_style())
		_menu.icon = get_theme_icon(&"GuiTabMenuHl", &"EditorIcons")
		_show_selection()
		if not entry.is_empty():
			show_entry(entry)


## Updates the row if it shows another entry or the entry changed.
func refresh(new_entry: String, has_new_value: bool) -> void:
	var scene := _document.scene
	if (
		has_new_value
		or new_entry != entry
		or scene.get_expression(entry) != _shown_expression
		or scene.get_entry_attributes(entry) != _shown_attributes
	):
		show_entry(new_entry)


## Shows the entry of that name.
func show_entry(new_entry: String) -> void:
	entry = new_entry
	var scene := _document.scene
	_set_text(_name, entry)
	_shown_expression = scene.get_expression(entry)
	_shown_attributes = scene.get_entry_attributes(entry)
	_set_text(_expression, _shown_expression)
	_expression.tooltip_text = _shown_expression
	var is_visible: bool = scene.get_entry_attribute(entry, "visible")
	var has_label: bool = scene.get_entry_attribute(entry, "label")
	_eye.set_pressed_no_signal(is_visible)
	_eye.icon = get_theme_icon(
		&"GuiVisibilityVisible" if is_visible else &"GuiVisibilityHidden", &"EditorIcons"
	)
	_label_toggle.set_pressed_no_signal(has_label)
	_label_toggle.icon = _label_icon_on if has_label else _label_icon
	_label_toggle.modulate = Color.WHITE if has_label else Color(1, 1, 1, 0.35)
	_swatch.show_entry(entry)
	_slider.show_entry(entry)
	_show_message(scene.get_description(entry), scene.get_error(entry))


func set_selected(value: bool) -> void:
	if value == selected:
		return
	selected = value
	_show_selection()
	_wrap_message()


func set_drop_side(value: Drop) -> void:
	drop_side = value
	queue_redraw()


## Calls Control.set_drag_forwarding() for the row and its parts.
func forward_drag(drag: Callable, can_drop: Callable, drop: Callable) -> void:
	set_drag_forwarding(drag, can_drop, drop)
	for part: Control in [_swatch, _name, _expression, _slider, _eye, _label_toggle, _menu]:
		part.set_drag_forwarding(Callable(), can_drop, drop)


## Starts editing the name.
func start_renaming() -> void:
	_name.edit()
	_name.select_all()


# The slider is aligned with the texts, to the right of the color.
func _make_slider_line() -> Control:
	var line := HBoxContainer.new()
	line.mouse_filter = Control.MOUSE_FILTER_PASS
	var space := Control.new()
	space.custom_minimum_size.x = ColorSwatch.WIDTH * PlaygroundStyle.scale()
	space.mouse_filter = Control.MOUSE_FILTER_PASS
	line.add_child(space)
	line.add_child(_slider)
	_slider.visibility_changed.connect(func() -> void: line.visible = _slider.visible)
	line.visible = _slider.visible
	return line


func _prepare_texts() -> void:
	var scale := PlaygroundStyle.scale()
	_name.name = "Name"
	_name.flat = true
	_name.expand_to_text_length = true
	_name.add_theme_constant_override(&"minimum_character_width", 2)
	_name.custom_minimum_size.x = NAME_WIDTH * scale
	_name.tooltip_text = "Name of the entry. Renaming it updates all expressions that refer to it."
	_name.text_submitted.connect(_on_name_submitted)
	_name.focus_exited.connect(_commit_name)
	_name.text_changed.connect(_on_name_typed)
	_name.gui_input.connect(_on_text_input.bind(_name))
	_equals.text = "="
	_equals.modulate = DIMMED
	_expression.name = "Expression"
	_expression.flat = true
	_expression.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_expression.text_submitted.connect(_on_expression_submitted)
	_expression.focus_exited.connect(_commit_expression)
	_expression.text_changed.connect(_on_expression_typed)
	_expression.gui_input.connect(_on_text_input.bind(_expression))
	_error_icon.stretch_mode = TextureRect.STRETCH_KEEP_CENTERED
	_error_icon.expand_mode = TextureRect.EXPAND_IGNORE_SIZE
	_error_icon.custom_minimum_size.x = ColorSwatch.WIDTH * scale
	_message.name = "Message"
	_message.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_message.mouse_filter = Control.MOUSE_FILTER_PASS


func _prepare_buttons() -> void:
	_eye.name = "Eye"
	_eye.tooltip_text = "Toggle the visibility of the object."
	_eye.toggle_mode = true
	_eye.toggled.connect(func(on: bool) -> void: _edits.set_attribute(entry, "visible", on))
	_label_toggle.name = "Label"
	_label_toggle.tooltip_text = "Toggle the label of the object."
	_label_toggle.toggle_mode = true
	_label_toggle.toggled.connect(func(on: bool) -> void: _edits.set_attribute(entry, "label", on))
	# The icons already have their colors.
	for color: StringName in [&"icon_pressed_color", &"icon_hover_pressed_color"]:
		_label_toggle.add_theme_color_override(color, Color.WHITE)
	_menu.name = "Menu"
	_menu.tooltip_text = "Open the menu of the entry. You can also right-click the entry."
	_menu.pressed.connect(func() -> void: menu_requested.emit(self))
	for button: Button in [_eye, _label_toggle, _menu]:
		button.flat = true
		button.size_flags_vertical = Control.SIZE_SHRINK_BEGIN
		button.focus_mode = Control.FOCUS_NONE
		for style: StringName in [&"normal", &"hover", &"pressed", &"hover_pressed", &"disabled"]:
			button.add_theme_stylebox_override(style, _button_style())


func _draw() -> void:
	if drop_side != Drop.NONE:
		var width := DROP_LINE * PlaygroundStyle.scale()
		var top := 0.0 if drop_side == Drop.ABOVE else size.y - width
		draw_rect(Rect2(0.0, top, size.x, width), get_theme_color(&"accent_color", &"Editor"))


func _gui_input(event: InputEvent) -> void:
	var click := event as InputEventMouseButton
	if click == null or not click.pressed:
		return
	if click.button_index == MOUSE_BUTTON_LEFT:
		pressed.emit(self, click.is_command_or_control_pressed() or click.shift_pressed)
	elif click.button_index == MOUSE_BUTTON_RIGHT:
		menu_requested.emit(self)


## A click in a text field also selects the entry. Esc restores the text.
func _on_text_input(event: InputEvent, edit: LineEdit) -> void:
	var click := event as InputEventMouseButton
	if click != null and click.pressed and click.button_index == MOUSE_BUTTON_LEFT:
		pressed.emit(self, click.is_command_or_control_pressed() or click.shift_pressed)
	elif event.is_action_pressed(&"ui_cancel"):
		edit.text = entry if edit == _name else _document.scene.get_expression(entry)
		show_entry(entry)


func _on_name_submitted(_text: String) -> void:
	_name.unedit()
	_commit_name()


func _on_expression_submitted(_text: String) -> void:
	_commit_expression()


func _on_name_typed(text: String) -> void:
	_show_error("" if text == entry else _document.scene.get_name_error(text))


func _on_expression_typed(text: String) -> void:
	var found := _document.scene.describe_expression(text, entry)
	_show_message(found["description"] as String, found["error"] as String)


func _commit_name() -> void:
	var text := _name.text.strip_edges()
	var scene := _document.scene
	if text != entry and scene.has_entry(entry) and scene.get_name_error(text).is_empty():
		_edits.rename(entry, text)
	elif scene.has_entry(entry):
		_name.text = entry
		show_entry(entry)


func _commit_expression() -> void:
	if (
		_document.scene.has_entry(entry)
		and _expression.text != _document.scene.get_expression(entry)
	):
		_edits.set_expression(entry, _expression.text)


func _show_message(description: String, error: String) -> void:
	_show_error(error)
	if error.is_empty():
		_message.text = description
		_message.tooltip_text = description


## Shows the error. An empty text removes it.
func _show_error(error: String) -> void:
	var is_wrong := not error.is_empty()
	_error_icon.texture = get_theme_icon(&"StatusError", &"EditorIcons") if is_wrong else null
	_message.modulate = Color.WHITE if is_wrong else DIMMED
	if is_wrong:
		_message.text = error
		_message.tooltip_text = error
		_message.add_theme_color_override(&"font_color", get_theme_color(&"error_color", &"Editor"))
	else:
		_message.remove_theme_color_override(&"font_color")
	_wrap_message()


# Wraps the text of selected entries and of errors; trims all others to one line.
func _wrap_message() -> void:
	var is_wrapped := selected or _error_icon.texture != null
	_message.autowrap_mode = (
		TextServer.AUTOWRAP_WORD_SMART if is_wrapped else TextServer.AUTOWRAP_OFF
	)
	_message.text_overrun_behavior = (
		TextServer.OVERRUN_NO_TRIMMING if is_wrapped else TextServer.OVERRUN_TRIM_ELLIPSIS
	)
	# Without this, changing the mode twice within a frame leaves the label too high.
	(_message.get_parent() as Container).queue_sort()


# The margins are smaller than those of the theme's buttons.
func _button_style() -> StyleBox:
	var style := StyleBoxEmpty.new()
	style.set_content_margin_all(BUTTON_MARGIN * PlaygroundStyle.scale())
	return style


# Aligns the text with the name, and its first line with the buttons.
func _message_style() -> StyleBox:
	# Looked up by type, as the row is notified of a theme change before its parts.
	var style := StyleBoxEmpty.new()
	style.content_margin_left = get_theme_stylebox(&"normal", &"LineEdit").get_margin(SIDE_LEFT)
	var button := (
		get_theme_icon(&"GuiTabMenuHl", &"EditorIcons").get_height()
		+ 2.0 * BUTTON_MARGIN * PlaygroundStyle.scale()
	)
	var text := get_theme_font(&"font", &"Label").get_height(
		get_theme_font_size(&"font_size", &"Label")
	)
	style.content_margin_top = maxf(0.0, (button - text) / 2.0)
	style.content_margin_bottom = style.content_margin_top
	return style


func _show_selection() -> void:
	var style: StyleBox = (
		get_theme_stylebox(&"selected", &"Tree").duplicate() if selected else StyleBoxEmpty.new()
	)
	style.set_content_margin_all(3 * PlaygroundStyle.scale())
	# An override causes another theme notification.
	_is_styling = true
	add_theme_stylebox_override(&"panel", style)
	_is_styling = false


# Does not overwrite a text that the user is editing.
func _set_text(edit: LineEdit, text: String) -> void:
	if edit.text != text and not (edit.has_focus() and edit.is_editing()):
		edit.text = text
