extends MarginContainer
## Arranges a HUD: panels in a column on the left; in the rest of the window, players at the top and
## keys at the bottom. The scene is shown between them.

const PlayerList := preload("player_list.gd")

const MARGIN := 16
const GAP := 12
## Minimum size of the window; in a smaller one the HUD is scaled down.
const MIN_SIZE := Vector2(1080.0, 560.0)

var players := PlayerList.new()

## Where the scene is shown.
var _free := Control.new()


func _init(panels: Array[Control], keys: String) -> void:
	for side: String in ["left", "top", "right", "bottom"]:
		add_theme_constant_override("margin_" + side, MARGIN)
	mouse_filter = Control.MOUSE_FILTER_IGNORE
	var columns := HBoxContainer.new()
	columns.mouse_filter = Control.MOUSE_FILTER_IGNORE
	columns.add_theme_constant_override(&"separation", GAP)
	add_child(columns)
	var left := VBoxContainer.new()
	left.mouse_filter = Control.MOUSE_FILTER_IGNORE
	left.add_theme_constant_override(&"separation", GAP)
	for panel: Control in panels:
		left.add_child(_in_panel(panel))
	columns.add_child(left)
	columns.add_child(_make_right(keys))


## Scales the HUD to the window. Call it every frame.
func fit_window() -> void:
	var window := get_viewport().get_visible_rect().size
	var factor := minf(1.0, minf(window.x / MIN_SIZE.x, window.y / MIN_SIZE.y))
	scale = Vector2.ONE * factor
	size = window / factor


## The part of the window that no panel covers, as a share of its size.
func get_free_area() -> Rect2:
	if not visible:
		return Rect2(0.0, 0.0, 1.0, 1.0)
	var window := get_viewport().get_visible_rect().size
	var area := _free.get_global_rect()
	return Rect2(area.position / window, area.size / window)


func _make_right(keys: String) -> VBoxContainer:
	var right := VBoxContainer.new()
	right.mouse_filter = Control.MOUSE_FILTER_IGNORE
	right.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_free.mouse_filter = Control.MOUSE_FILTER_IGNORE
	_free.size_flags_vertical = Control.SIZE_EXPAND_FILL
	players.size_flags_horizontal = Control.SIZE_SHRINK_CENTER
	var label := Label.new()
	label.text = keys
	label.theme_type_variation = &"CaptionLabel"
	var panel := _in_panel(label)
	panel.mouse_filter = Control.MOUSE_FILTER_IGNORE
	panel.size_flags_horizontal = Control.SIZE_SHRINK_CENTER
	for row: Control in [players, _free, panel]:
		right.add_child(row)
	return right


func _in_panel(content: Control) -> PanelContainer:
	var panel := PanelContainer.new()
	panel.add_child(content)
	return panel
