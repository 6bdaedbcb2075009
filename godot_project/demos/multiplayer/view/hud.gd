extends CanvasLayer
## The client's figures, players and hints over the picture.

const Client := preload("../client.gd")
const Palette := preload("palette.gd")
const Sparkline := preload("sparkline.gd")

const METHOD_TITLES: Dictionary[String, String] = {
	"motors": "Quantised motors", "synchronizer": "MultiplayerSynchronizer",
}
const UPDATE_PAUSE := 0.5
const EDGE := 16
const PANEL_WIDTH := 236

var _title := Label.new()
var _subtitle := Label.new()
var _rate := Label.new()
var _curve := Sparkline.new()
var _figures: Dictionary[String, Label] = {}
var _players := VBoxContainer.new()
var _panels: Array[Control] = []
var _message := Label.new()
var _next_update := 0.0
var _poses := 0
var _bytes := 0
var _packets := 0
var _updated_at := 0.0


func _init() -> void:
	_add_figures()
	_add_players()
	_add_hint()
	_message.theme_type_variation = &"HeadingLabel"
	_message.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	_message.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
	_message.vertical_alignment = VERTICAL_ALIGNMENT_CENTER
	add_child(_message)
	_set_panels_visible(false)


func show_message(text: String) -> void:
	_message.text = text


func show_session(cubes: int, method: String) -> void:
	_title.text = METHOD_TITLES[method]
	_subtitle.text = "%d cubes, simulated on the server" % cubes
	_set_panels_visible(true)


func show_players(roster: Array, own_slot: int) -> void:
	for child: Node in _players.get_children():
		child.queue_free()
	for player: Array in roster:
		var slot: int = player[0]
		var player_name: String = player[2]
		_players.add_child(_make_player(slot, player_name + (" (you)" if slot == own_slot else "")))


## Reads the client's counters, twice a second.
func show_traffic(client: Client) -> void:
	var now := Time.get_ticks_usec() * 1e-6
	if now < _next_update:
		return
	_next_update = now + UPDATE_PAUSE
	var elapsed := maxf(now - _updated_at, 0.001)
	var poses_per_second := (client.link.pose_count - _poses) / elapsed
	var rate := (client.meter.bytes - _bytes) / elapsed
	var packets_per_second := (client.meter.packets - _packets) / elapsed
	_poses = client.link.pose_count
	_bytes = client.meter.bytes
	_packets = client.meter.packets
	_updated_at = now
	_rate.text = "%.1f kB/s" % (rate / 1000.0)
	_curve.push(rate)
	_figures["Packets"].text = "%.0f /s" % packets_per_second
	_figures["Pose updates"].text = "%.0f /s" % poses_per_second
	_figures["Bytes a pose"].text = "%.1f" % (rate / poses_per_second) if poses_per_second > 10.0 else "–"
	var delay := client.link.get_delay_ms(now)
	_figures["Playback delay"].text = "%.0f ms" % delay if delay > 0.0 else "none"


func _add_figures() -> void:
	var column := _add_panel(Control.PRESET_TOP_LEFT, Vector2(EDGE, EDGE))
	column.custom_minimum_size.x = PANEL_WIDTH
	_title.theme_type_variation = &"HeadingLabel"
	_subtitle.theme_type_variation = &"CaptionLabel"
	_rate.add_theme_font_size_override("font_size", 30)
	_rate.add_theme_color_override("font_color", Palette.ACCENT)
	_curve.color = Palette.ACCENT
	_curve.custom_minimum_size = Vector2(PANEL_WIDTH, 36)
	for part: Control in [_title, _subtitle, _rate, _curve]:
		column.add_child(part)
	for name_of_figure: String in ["Packets", "Pose updates", "Bytes a pose", "Playback delay"]:
		var row := HBoxContainer.new()
		var caption := Label.new()
		caption.text = name_of_figure
		caption.theme_type_variation = &"CaptionLabel"
		caption.size_flags_horizontal = Control.SIZE_EXPAND_FILL
		var value := Label.new()
		row.add_child(caption)
		row.add_child(value)
		column.add_child(row)
		_figures[name_of_figure] = value


func _add_players() -> void:
	var column := _add_panel(Control.PRESET_TOP_RIGHT, Vector2(-EDGE, EDGE))
	column.add_child(_players)


func _add_hint() -> void:
	var hint := Label.new()
	hint.text = "WASD or arrows: roll   ·   Space: jump   ·   Click: kick a cube   ·   Right mouse button, wheel: camera"
	hint.theme_type_variation = &"CaptionLabel"
	var panel := PanelContainer.new()
	panel.mouse_filter = Control.MOUSE_FILTER_IGNORE
	panel.add_child(hint)
	panel.size_flags_horizontal = Control.SIZE_SHRINK_CENTER
	panel.size_flags_vertical = Control.SIZE_SHRINK_END
	var frame := MarginContainer.new()
	frame.mouse_filter = Control.MOUSE_FILTER_IGNORE
	frame.add_theme_constant_override("margin_bottom", EDGE)
	frame.add_child(panel)
	frame.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	_panels.append(frame)
	add_child(frame)


func _add_panel(preset: Control.LayoutPreset, offset: Vector2) -> VBoxContainer:
	var panel := PanelContainer.new()
	panel.mouse_filter = Control.MOUSE_FILTER_IGNORE
	panel.set_anchors_and_offsets_preset(preset)
	panel.position += offset
	if preset == Control.PRESET_TOP_RIGHT:
		panel.grow_horizontal = Control.GROW_DIRECTION_BEGIN
	var column := VBoxContainer.new()
	column.add_theme_constant_override("separation", 3)
	panel.add_child(column)
	add_child(panel)
	_panels.append(panel)
	return column


func _make_player(slot: int, text: String) -> Control:
	var row := HBoxContainer.new()
	var dot := Panel.new()
	var style := StyleBoxFlat.new()
	style.bg_color = Palette.get_player_color(slot)
	style.set_corner_radius_all(5)
	dot.add_theme_stylebox_override("panel", style)
	dot.custom_minimum_size = Vector2(10, 10)
	dot.size_flags_vertical = Control.SIZE_SHRINK_CENTER
	var label := Label.new()
	label.text = text
	row.add_child(dot)
	row.add_child(label)
	return row


func _set_panels_visible(value: bool) -> void:
	for panel: Control in _panels:
		panel.visible = value
