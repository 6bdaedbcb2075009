extends PanelContainer
## The names of the players with their colors, in a row.

const Palette := preload("palette.gd")

const DOT := 10

var _row := HBoxContainer.new()


func _init() -> void:
	mouse_filter = Control.MOUSE_FILTER_IGNORE
	_row.add_theme_constant_override(&"separation", 18)
	add_child(_row)


## [param roster] holds [slot, peer, name] for each player.
func show_players(roster: Array, own_slot: int) -> void:
	for child: Node in _row.get_children():
		child.queue_free()
	for player: Array in roster:
		var slot: int = player[0]
		var player_name: String = player[2]
		_row.add_child(_make_player(slot, player_name + (" (you)" if slot == own_slot else "")))


func _make_player(slot: int, text: String) -> Control:
	var row := HBoxContainer.new()
	row.add_theme_constant_override(&"separation", 6)
	var dot := Panel.new()
	var style := StyleBoxFlat.new()
	style.bg_color = Palette.get_player_color(slot)
	style.set_corner_radius_all(DOT >> 1)
	dot.add_theme_stylebox_override(&"panel", style)
	dot.custom_minimum_size = Vector2(DOT, DOT)
	dot.size_flags_vertical = Control.SIZE_SHRINK_CENTER
	var label := Label.new()
	label.text = text
	row.add_child(dot)
	row.add_child(label)
	return row
