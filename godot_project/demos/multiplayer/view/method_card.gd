extends Button
## A button for a replication method, with its data rate as text and as a bar.

const HEIGHT := 58
const MARGIN := 8
const BAR_HEIGHT := 4.0

var _color: Color
var _rate := Label.new()
var _share := 0.0


func _init(title: String, description: String, color: Color, group: ButtonGroup) -> void:
	_color = color
	toggle_mode = true
	button_group = group
	# Keep Space and the arrow keys for the player.
	focus_mode = Control.FOCUS_NONE
	custom_minimum_size.y = HEIGHT
	var lines := VBoxContainer.new()
	lines.set_anchors_and_offsets_preset(
		Control.PRESET_FULL_RECT, Control.PRESET_MODE_MINSIZE, MARGIN
	)
	lines.offset_bottom = -MARGIN - BAR_HEIGHT
	lines.alignment = BoxContainer.ALIGNMENT_CENTER
	lines.add_theme_constant_override(&"separation", -3)
	lines.mouse_filter = Control.MOUSE_FILTER_IGNORE
	add_child(lines)
	var row := HBoxContainer.new()
	row.mouse_filter = Control.MOUSE_FILTER_IGNORE
	var heading := _make_label(title, &"Label")
	heading.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	row.add_child(heading)
	_rate.add_theme_color_override(&"font_color", color)
	_rate.mouse_filter = Control.MOUSE_FILTER_IGNORE
	row.add_child(_rate)
	lines.add_child(row)
	lines.add_child(_make_label(description, &"CaptionLabel"))
	show_rate(-1.0, 0.0)


## Shows a rate in bytes per second, negative if not yet measured, and its share of the highest
## rate.
func show_rate(rate: float, share: float) -> void:
	_rate.text = "%.1f kB/s" % (rate / 1000.0) if rate >= 0.0 else "not measured"
	_rate.theme_type_variation = &"Label" if rate >= 0.0 else &"CaptionLabel"
	_rate.modulate.a = 1.0 if button_pressed or rate < 0.0 else 0.7
	_share = share
	queue_redraw()


func _draw() -> void:
	var width := size.x - 2.0 * MARGIN
	var at := Vector2(MARGIN, size.y - MARGIN - BAR_HEIGHT + 1.0)
	draw_rect(Rect2(at, Vector2(width, BAR_HEIGHT)), Color(1.0, 1.0, 1.0, 0.07))
	draw_rect(
		Rect2(at, Vector2(maxf(width * _share, 2.0 if _share > 0.0 else 0.0), BAR_HEIGHT)), _color
	)


func _make_label(text: String, variation: StringName) -> Label:
	var label := Label.new()
	label.text = text
	label.theme_type_variation = variation
	label.mouse_filter = Control.MOUSE_FILTER_IGNORE
	return label
