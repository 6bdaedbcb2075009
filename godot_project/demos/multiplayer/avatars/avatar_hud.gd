extends CanvasLayer
## The HUD of the scene of avatars: the traffic of this client and its playback delay.

const AvatarClient := preload("avatar_client.gd")
const HudLayout := preload("../view/hud_layout.gd")
const StatisticRow := preload("../view/statistic_row.gd")

const KEYS := "Right drag, wheel: camera   ·   H: toggle panels"
const UPDATE_INTERVAL := 0.5
const WIDTH := 270
const STATISTICS: PackedStringArray = [
	"Server", "Forwarded by", "Received", "Datagrams received", "Packet loss", "Playback delay"
]

var _client: AvatarClient
var _column := VBoxContainer.new()
var _panels := HudLayout.new([_column], KEYS)
var _message := Label.new()
var _values: Dictionary[String, Label] = {}
var _shown_roster: Array = []
var _updated_at := 0.0
var _bytes := 0
var _packets := 0
var _lost := 0


func _init(client: AvatarClient) -> void:
	_client = client
	_column.custom_minimum_size.x = WIDTH
	for statistic: String in STATISTICS:
		var row := StatisticRow.new(statistic)
		row.value.text = "–"
		_values[statistic] = row.value
		_column.add_child(row)
	add_child(_panels)
	_message.theme_type_variation = &"HeadingLabel"
	_message.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	_message.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
	_message.vertical_alignment = VERTICAL_ALIGNMENT_CENTER
	add_child(_message)


func show_message(text: String) -> void:
	_message.text = text


## The part of the window that no panel covers, as a share of its size.
func get_free_area() -> Rect2:
	return _panels.get_free_area()


## Call it every frame.
func update() -> void:
	_panels.fit_window()
	if _shown_roster != _client.roster:
		_shown_roster = _client.roster
		_message.text = ""
		_panels.players.show_players(_shown_roster, _client.get_own_slot())
	var now := Time.get_ticks_usec() * 1e-6
	if now > _updated_at + UPDATE_INTERVAL and not _shown_roster.is_empty():
		_show_statistics(now - _updated_at)
		_updated_at = now


func _unhandled_key_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if key.pressed and not key.echo and key.keycode == KEY_H:
		_panels.visible = not _panels.visible


func _show_statistics(elapsed: float) -> void:
	var meter := _client.meter
	var packets := meter.packets - _packets
	var statistics := _client.group.synchronizer.get_statistics()
	var delay: float = statistics["playback_delay"]
	_values["Server"].text = _client.get_server()
	_values["Forwarded by"].text = "MotorSynchronizer" if _client.method == "on" else "Godot"
	_values["Received"].text = "%.1f kB/s" % ((meter.bytes - _bytes) / elapsed / 1000.0)
	_values["Datagrams received"].text = "%.0f/s" % (packets / elapsed)
	_values["Packet loss"].text = "%.0f%%" % (100.0 * (meter.lost - _lost) / maxi(packets, 1))
	_values["Playback delay"].text = "%.0f ms" % (delay * 1000.0)
	_bytes = meter.bytes
	_packets = meter.packets
	_lost = meter.lost
