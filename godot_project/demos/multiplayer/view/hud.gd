extends CanvasLayer
## The HUD of a client of the scenes of cubes: statistics and controls. H toggles the panels, M
## switches the method.

const Client := preload("../client.gd")
const ControlsPanel := preload("controls_panel.gd")
const HudLayout := preload("hud_layout.gd")
const StatisticsPanel := preload("statistics_panel.gd")

const KEYS := (
	"WASD, arrows: roll   ·   Space: jump   ·   Click: kick   ·   Right drag, wheel: camera   ·   "
	+ "M: switch method   ·   H: toggle panels"
)

var _client: Client
var _statistics := StatisticsPanel.new()
var _controls := ControlsPanel.new()
var _panels := HudLayout.new([_statistics, _controls], KEYS)
var _message := Label.new()


func _init(client: Client) -> void:
	_client = client
	_panels.hide()
	add_child(_panels)
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
	_panels.players.show_players(roster, own_slot)


## The part of the window that no panel covers, as a share of its size.
func get_free_area() -> Rect2:
	return _panels.get_free_area()


## Call it every frame.
func update() -> void:
	_panels.fit_window()
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
