extends VBoxContainer
## What the poses cost and how good they are: a card for each method, the rate as a curve, and figures.

## The player wants the other method.
signal method_wanted(method: String)

const Client := preload("../client.gd")
const MethodCard := preload("method_card.gd")
const Palette := preload("palette.gd")
const Sparkline := preload("sparkline.gd")

const TITLES: Dictionary[String, String] = {
	"motors": "MotorSynchronizer",
	"synchronizer": "MultiplayerSynchronizer",
}
const LINES: Dictionary[String, String] = {
	"motors": "GA-Godot: what the tolerance asks for",
	"synchronizer": "Godot: every transform, 20 times a second",
}
const FIGURES: PackedStringArray = [
	"Packets",
	"Loss",
	"Playback delay",
	"Error, median",
	"Error, worst of 2 s",
]
const UPDATE_PAUSE := 0.5
## Readings after a change of method that still hold some of the old one's bytes, or its beginning.
const SETTLING := 2
## Share of the last reading in the rate that is shown.
const NEWEST_SHARE := 0.4
const WIDTH := 270

var _cards: Dictionary[String, MethodCard] = {}
## Bytes a second of each method when last measured.
var _rates: Dictionary[String, float] = {}
var _curve := Sparkline.new()
var _values: Dictionary[String, Label] = {}
var _method := ""
var _settling := 0
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
		card.pressed.connect(method_wanted.emit.bind(method))
		add_child(card)
		_cards[method] = card
	_curve.custom_minimum_size.y = 34
	add_child(_curve)
	var rows := VBoxContainer.new()
	rows.add_theme_constant_override(&"separation", 2)
	for figure: String in FIGURES:
		rows.add_child(_make_row(figure))
	add_child(rows)


## The method by which the poses come now.
func show_method(method: String) -> void:
	_method = method
	_settling = SETTLING
	for other: String in _cards:
		_cards[other].set_pressed_no_signal(other == method)
	_curve.begin(Palette.METHODS[method])


## Reads the client's counters, twice a second.
func update(client: Client) -> void:
	var now := Time.get_ticks_usec() * 1e-6
	if now < _next_update:
		return
	_next_update = now + UPDATE_PAUSE
	client.meter.update()
	var elapsed := maxf(now - _updated_at, 0.001)
	var packets := client.meter.packets - _packets
	var lost := client.meter.lost - _lost
	var rate := (client.meter.bytes - _bytes) / elapsed
	_updated_at = now
	_bytes = client.meter.bytes
	_packets = client.meter.packets
	_lost = client.meter.lost
	_settling -= 1
	if _settling < 0:
		_rates[_method] = (
			lerpf(_rates[_method], rate, NEWEST_SHARE) if _rates.has(_method) else rate
		)
		_curve.push(rate)
	_show_rates()
	_values["Packets"].text = "%.0f /s" % (packets / elapsed)
	_values["Loss"].text = "%.0f %%" % (100.0 * lost / maxi(packets, 1))
	var delay := client.link.get_delay() * 1000.0
	_values["Playback delay"].text = "%.0f ms" % delay if delay > 0.0 else "none"
	_show_errors(client)


func _show_rates() -> void:
	var most := 1.0
	for method: String in _rates:
		most = maxf(most, _rates[method])
	for method: String in _cards:
		var rate: float = _rates.get(method, -1.0)
		_cards[method].show_rate(rate, maxf(rate, 0.0) / most)


func _show_errors(client: Client) -> void:
	var is_known := client.gauge.has_errors()
	var errors := client.gauge.get_figures() * 1000.0 if is_known else Vector2.ZERO
	_values["Error, median"].text = "%.1f mm" % errors.x if is_known else "–"
	_values["Error, worst of 2 s"].text = "%.1f mm" % errors.y if is_known else "–"


func _make_row(caption: String) -> Control:
	var row := HBoxContainer.new()
	var label := Label.new()
	label.text = caption
	label.theme_type_variation = &"CaptionLabel"
	label.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	var value := Label.new()
	row.add_child(label)
	row.add_child(value)
	_values[caption] = value
	return row
