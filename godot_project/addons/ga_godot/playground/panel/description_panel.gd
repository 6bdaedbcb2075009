@tool
extends PanelContainer
## Shows the scene attributes "title" and "description". Hidden if both are empty.
## Once closed, the panel stays hidden until a scene with other texts is shown.

const PlaygroundStyle := preload("../theme/playground_style.gd")

const TITLE := "title"
const DESCRIPTION := "description"
const MARGIN := 8.0
const TITLE_SCALE := 1.15
const TEXT_OPACITY := 0.85
## Lines of text that are visible without scrolling.
const MAX_LINES := 6

## Null hides the panel.
var scene: GAScene:
	set = set_scene

var _title := Label.new()
var _scroll := ScrollContainer.new()
var _text := Label.new()
var _close := Button.new()
var _closed_text := ""


func _init() -> void:
	name = "Description"
	visible = false
	var margin := MarginContainer.new()
	for side: StringName in [&"margin_left", &"margin_top", &"margin_right", &"margin_bottom"]:
		margin.add_theme_constant_override(side, roundi(MARGIN * PlaygroundStyle.scale()))
	add_child(margin)
	var column := VBoxContainer.new()
	margin.add_child(column)
	var head := HBoxContainer.new()
	column.add_child(head)
	_title.name = "Title"
	_title.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_title.size_flags_horizontal = SIZE_EXPAND_FILL
	head.add_child(_title)
	_close.name = "Close"
	_close.theme_type_variation = &"FlatButton"
	_close.tooltip_text = "Close the description."
	_close.focus_mode = FOCUS_NONE
	_close.size_flags_vertical = SIZE_SHRINK_BEGIN
	_close.pressed.connect(close)
	head.add_child(_close)
	_text.name = "Text"
	_text.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_text.modulate = Color(1.0, 1.0, 1.0, TEXT_OPACITY)
	_text.size_flags_horizontal = SIZE_EXPAND_FILL
	_text.minimum_size_changed.connect(_fit_height)
	_scroll.horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	_scroll.add_child(_text)
	column.add_child(_scroll)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED or what == NOTIFICATION_ENTER_TREE:
		_close.icon = get_theme_icon(&"Close", &"EditorIcons")
		_title.add_theme_font_size_override(
			&"font_size", roundi(get_theme_default_font_size() * TITLE_SCALE)
		)
	elif what == NOTIFICATION_PREDELETE:
		scene = null


func set_scene(new_scene: GAScene) -> void:
	if scene != null and scene.changed.is_connected(_show_texts):
		scene.changed.disconnect(_show_texts)
	scene = new_scene
	if scene != null:
		scene.changed.connect(_show_texts)
		_show_texts()
	else:
		visible = false


## Hides the panel until a scene with other texts is shown.
func close() -> void:
	_closed_text = _title.text + _text.text
	visible = false


func _show_texts() -> void:
	_title.text = _text_of(TITLE)
	_text.text = _text_of(DESCRIPTION)
	_scroll.visible = not _text.text.is_empty()
	_scroll.scroll_vertical = 0
	var all := _title.text + _text.text
	visible = not all.is_empty() and all != _closed_text


func _fit_height() -> void:
	_scroll.custom_minimum_size.y = minf(
		_text.get_minimum_size().y, MAX_LINES * _text.get_line_height()
	)


func _text_of(key: String) -> String:
	var text: Variant = scene.get_scene_attribute(key)
	return (text as String).strip_edges() if text is String else ""
