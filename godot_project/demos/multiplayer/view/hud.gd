extends CanvasLayer
## The HUD of a client: statistics on the left, controls on the right, players at the top, keys at
## the bottom. H toggles the panels, M switches the method.

const Client := preload("../client.gd")
const ControlsPanel := preload("controls_panel.gd")
const StatisticsPanel := preload("statistics_panel.gd")
const PlayerList := preload("player_list.gd")

const MARGIN := 16
const KEYS := (
	"WASD, arrows: roll   ·   Space: jump   ·   Click: kick   ·   Right drag, wheel: camera   ·   "
	+ "M: switch method   ·   H: toggle panels"
)

var _client: Client
var _statistics := StatisticsPanel.new()
var _controls := ControlsPanel.new()
var _players := PlayerList.new()
var _panels := Control.new()
var _message := Label.new()


func _init(client: Client) -> void:
	_client = client
	_panels.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	_panels.mouse_filter = Control.MOUSE_FILTER_IGNORE
	_panels.hide()
	add_child(_panels)
	_add_to_edge(_in_panel(_statistics), Control.SIZE_SHRINK_BEGIN, Control.SIZE_SHRINK_BEGIN)
	_add_to_edge(_in_panel(_controls), Control.SIZE_SHRINK_END, Control.SIZE_SHRINK_BEGIN)
	_add_to_edge(_players, Control.SIZE_SHRINK_CENTER, Control.SIZE_SHRINK_BEGIN)
	_add_to_edge(_make_keys(), Control.SIZE_SHRINK_CENTER, Control.SIZE_SHRINK_END)
	_message.theme_type_variation = &"HeadingLabel"
	_message.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	_message.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
	_message.vertical_alignment = VERTICAL_ALIGNMENT_CENTER
	add_child(_message)
	_statistics.method_requested.connect(client.request_method)
	_controls.conditions_changed.connect(client.set_conditions)
	_controls.tuning_requested.connect(client.request_tuning)
	client.method_changed.connect(_on_method_changed)
	client.tuned.connect(_on_tuned)


func show_message(text: String) -> void:
	_message.text = text


## Shows the panels when the session begins.
func open() -> void:
	_message.text = ""
	_on_method_changed()
	_on_tuned()
	_controls.show_conditions(_client.conditions)
	_panels.show()
	_client.request_truth(true)


func show_players(roster: Array, own_slot: int) -> void:
	_players.show_players(roster, own_slot)


## Call it every frame.
func update() -> void:
	_statistics.update(_client)


func _unhandled_key_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if not key.pressed or key.echo or _client.link == null:
		return
	if key.keycode == KEY_H:
		_panels.visible = not _panels.visible
		# Hidden statistics need no ground truth.
		_client.request_truth(_panels.visible)
	elif key.keycode == KEY_M:
		_client.request_method("synchronizer" if _client.method == "motors" else "motors")


func _on_method_changed() -> void:
	_statistics.show_method(_client.method)


func _on_tuned() -> void:
	_controls.show_tuning(_client.tolerance, _client.mode)


func _in_panel(content: Control) -> PanelContainer:
	var panel := PanelContainer.new()
	panel.add_child(content)
	return panel


func _add_to_edge(
	panel: Control, horizontal: Control.SizeFlags, vertical: Control.SizeFlags
) -> void:
	var frame := MarginContainer.new()
	frame.mouse_filter = Control.MOUSE_FILTER_IGNORE
	frame.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	for side: String in ["left", "top", "right", "bottom"]:
		frame.add_theme_constant_override("margin_" + side, MARGIN)
	panel.size_flags_horizontal = horizontal
	panel.size_flags_vertical = vertical
	frame.add_child(panel)
	_panels.add_child(frame)


func _make_keys() -> PanelContainer:
	var keys := Label.new()
	keys.text = KEYS
	keys.theme_type_variation = &"CaptionLabel"
	var panel := _in_panel(keys)
	panel.mouse_filter = Control.MOUSE_FILTER_IGNORE
	return panel
