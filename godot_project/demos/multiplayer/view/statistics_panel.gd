extends VBoxContainer
## Statistics of the replication: a card per method, the data rate as a graph, and errors.

## Emitted when the player chooses a method.
signal method_requested(method: String)

const Client := preload("../client.gd")
const MethodCard := preload("method_card.gd")
const Palette := preload("palette.gd")
const Sparkline := preload("sparkline.gd")
const StatisticRow := preload("statistic_row.gd")

const TITLES: Dictionary[String, String] = {
	"motors": "MotorSynchronizer",
	"synchronizer": "MultiplayerSynchronizer",
}
const LINES: Dictionary[String, String] = {
	"motors": "GA-Godot: only what the tolerance requires",
	"synchronizer": "Godot: every transform at 20 Hz",
}
const STATISTICS: PackedStringArray = [
	"Server",
	"Packets",
	"Packet loss",
	"Playback delay",
	"Median error",
	"Maximum error (2 s)",
]
const UPDATE_INTERVAL := 0.5
## Readings to skip after a change of method: they contain bytes of the old method and the initial
## burst of the new one.
const SKIPPED_READINGS := 2
## Weight of the latest reading in the shown rate.
const LATEST_WEIGHT := 0.4
const WIDTH := 270

var _cards: Dictionary[String, MethodCard] = {}
## Last measured bytes per second by method.
var _rates: Dictionary[String, float] = {}
var _graph := Sparkline.new()
var _values: Dictionary[String, Label] = {}
var _method := ""
var _readings_to_skip := 0
var _next_update := 0.0
var _updated_at := 0.0
var _bytes := 0
var _packets := 0
var _lost := 0


func _init() -> void:
	custom_minimum_size.x = WIDTH
	add_theme_constant_override(&"separation", 6)
	var group := ButtonGroup.new()
	for method: String in TITLES:
		var card := MethodCard.new(TITLES[method], LINES[method], Palette.METHODS[method], group)
		card.pressed.connect(method_requested.emit.bind(method))
		add_child(card)
		_cards[method] = card
	_graph.custom_minimum_size.y = 34
	add_child(_graph)
	var rows := VBoxContainer.new()
	rows.add_theme_constant_override(&"separation", 2)
	for statistic: String in STATISTICS:
		var row := StatisticRow.new(statistic)
		_values[statistic] = row.value
		rows.add_child(row)
	add_child(rows)


## Shows the active method.
func show_method(method: String) -> void:
	_method = method
	_readings_to_skip = SKIPPED_READINGS
	for other: String in _cards:
		_cards[other].set_pressed_no_signal(other == method)
	_graph.begin(Palette.METHODS[method])


## Reads the counters of the client twice a second.
func update(client: Client) -> void:
	var now := Time.get_ticks_usec() * 1e-6
	if now < _next_update:
		return
	_next_update = now + UPDATE_INTERVAL
	client.meter.update()
	var elapsed := maxf(now - _updated_at, 0.001)
	var packets := client.meter.packets - _packets
	var lost := client.meter.lost - _lost
	var rate := (client.meter.bytes - _bytes) / elapsed
	_updated_at = now
	_bytes = client.meter.bytes
	_packets = client.meter.packets
	_lost = client.meter.lost
	_readings_to_skip -= 1
	if _readings_to_skip < 0:
		_rates[_method] = (
			lerpf(_rates[_method], rate, LATEST_WEIGHT) if _rates.has(_method) else rate
		)
		_graph.push(rate)
	_show_rates()
	_values["Server"].text = client.get_server()
	_values["Packets"].text = "%.0f/s" % (packets / elapsed)
	_values["Packet loss"].text = "%.0f%%" % (100.0 * lost / maxi(packets, 1))
	var delay := client.link.get_delay() * 1000.0
	_values["Playback delay"].text = "%.0f ms" % delay if delay > 0.0 else "none"
	_show_errors(client)


func _show_rates() -> void:
	var max_rate := 1.0
	for method: String in _rates:
		max_rate = maxf(max_rate, _rates[method])
	for method: String in _cards:
		var rate: float = _rates.get(method, -1.0)
		_cards[method].show_rate(rate, maxf(rate, 0.0) / max_rate)


func _show_errors(client: Client) -> void:
	var is_known := client.gauge.has_errors()
	var errors := client.gauge.get_statistics() * 1000.0 if is_known else Vector2.ZERO
	_values["Median error"].text = "%.1f mm" % errors.x if is_known else "–"
	_values["Maximum error (2 s)"].text = "%.1f mm" % errors.y if is_known else "–"
