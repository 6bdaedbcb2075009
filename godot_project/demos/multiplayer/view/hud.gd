extends CanvasLayer
## The HUD of a client: statistics and controls in a column on the left; in the rest of the window,
## players at the top and keys at the bottom. The scene is shown between them. H toggles the panels,
## M switches the method.

const Client := preload("../client.gd")
const ControlsPanel := preload("controls_panel.gd")
const StatisticsPanel := preload("statistics_panel.gd")
const PlayerList := preload("player_list.gd")

const MARGIN := 16
const GAP := 12
## Minimum size of the window; in a smaller one the HUD is scaled down.
const MIN_SIZE := Vector2(1080.0, 560.0)
const KEYS := (
	"WASD, arrows: roll   ·   Space: jump   ·   Click: kick   ·   Right drag, wheel: camera   ·   "
	+ "M: switch method   ·   H: toggle panels"
)

var _client: Client
var _statistics := StatisticsPanel.new()
var _controls := ControlsPanel.new()
var _players := PlayerList.new()
var _panels := MarginContainer.new()
## Where the scene is shown.
var _free := Control.new()
var _message := Label.new()


func _init(client: Client) -> void:
	_client = client
	for side: String in ["left", "top", "right", "bottom"]:
		_panels.add_theme_constant_override("margin_" + side, MARGIN)
	_panels.mouse_filter = Control.MOUSE_FILTER_IGNORE
	_panels.hide()
	add_child(_panels)
	_arrange()
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


## The part of the window that no panel covers, as a share of its size.
func get_free_area() -> Rect2:
	if not _panels.visible:
		return Rect2(0.0, 0.0, 1.0, 1.0)
	var window := get_viewport().get_visible_rect().size
	var rect := _free.get_global_rect()
	return Rect2(rect.position * scale / window, rect.size * scale / window)


## Call it every frame.
func update() -> void:
	var window := get_viewport().get_visible_rect().size
	var factor := minf(1.0, minf(window.x / MIN_SIZE.x, window.y / MIN_SIZE.y))
	scale = Vector2.ONE * factor
	_panels.size = window / factor
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


func _arrange() -> void:
	var columns := HBoxContainer.new()
	columns.mouse_filter = Control.MOUSE_FILTER_IGNORE
	columns.add_theme_constant_override(&"separation", GAP)
	_panels.add_child(columns)
	var left := VBoxContainer.new()
	left.mouse_filter = Control.MOUSE_FILTER_IGNORE
	left.add_theme_constant_override(&"separation", GAP)
	left.add_child(_in_panel(_statistics))
	left.add_child(_in_panel(_controls))
	columns.add_child(left)
	var right := VBoxContainer.new()
	right.mouse_filter = Control.MOUSE_FILTER_IGNORE
	right.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_free.mouse_filter = Control.MOUSE_FILTER_IGNORE
	_free.size_flags_vertical = Control.SIZE_EXPAND_FILL
	for row: Control in [_players, _free, _make_keys()]:
		row.size_flags_horizontal = (
			Control.SIZE_FILL if row == _free else Control.SIZE_SHRINK_CENTER
		)
		right.add_child(row)
	columns.add_child(right)


func _make_keys() -> PanelContainer:
	var keys := Label.new()
	keys.text = KEYS
	keys.theme_type_variation = &"CaptionLabel"
	var panel := _in_panel(keys)
	panel.mouse_filter = Control.MOUSE_FILTER_IGNORE
	return panel
