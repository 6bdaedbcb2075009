extends PanelContainer
## The right panel: the coefficients of the cube's motor, and the deviations between the paths of
## the modes.

const Modes := preload("res://addons/ga_godot/playground/lab/interpolation_modes.gd")

## The blades of a motor with scale, with their indices in Multivector.coefficients.
const MOTOR_BLADES: Dictionary[String, int] = {
	"1": 0,
	"e45": 15,
	"e12": 6,
	"e1245": 28,
	"e13": 7,
	"e1345": 29,
	"e23": 10,
	"e2345": 30,
	"e14": 8,
	"e15": 9,
	"e24": 11,
	"e25": 12,
	"e34": 13,
	"e35": 14,
	"e1234": 26,
	"e1235": 27,
}
const PAIRS: Array[Vector2i] = [Vector2i(0, 1), Vector2i(0, 2), Vector2i(1, 2)]
const BLADE_WIDTH := 40
const NUMBER_WIDTH := 56

var _coefficients: Array[Label] = []
## Distance and angle of each pair.
var _deviations: Array[Label] = []

@onready var _coefficient_grid: GridContainer = %Coefficients
@onready var _deviation_grid: GridContainer = %Deviations


func _ready() -> void:
	for blade: String in MOTOR_BLADES:
		_add_label(_coefficient_grid, blade, BLADE_WIDTH, &"CaptionLabel")
		_coefficients.append(_add_number(_coefficient_grid))
	_add_label(_deviation_grid, "Maximum", 0, &"CaptionLabel")
	for unit: String in ["mm", "degrees"]:
		var heading := _add_label(_deviation_grid, unit, NUMBER_WIDTH, &"CaptionLabel")
		heading.horizontal_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	for pair in PAIRS:
		_deviation_grid.add_child(_make_pair_label(pair))
		_deviations.append(_add_number(_deviation_grid))
		_deviations.append(_add_number(_deviation_grid))


func show_motor(motor: Multivector) -> void:
	var numbers := motor.coefficients
	var indices := MOTOR_BLADES.values()
	for i in _coefficients.size():
		var index: int = indices[i]
		var number := numbers[index]
		_coefficients[i].text = _format(number)
		_coefficients[i].modulate.a = 0.35 if absf(number) < 5e-5 else 1.0


## Shows the largest deviations of position and rotation along the paths between two poses.
func show_deviations(from: Multivector, to: Multivector) -> void:
	for i in PAIRS.size():
		var largest := MultivectorLerp.measure_deviation(
			from, to, PAIRS[i].x as MultivectorLerp.Mode, PAIRS[i].y as MultivectorLerp.Mode, 0.0
		)
		_deviations[2 * i].text = "%.0f" % (largest["distance"] * 1000.0)
		_deviations[2 * i + 1].text = "%.2f" % rad_to_deg(largest["angle"] as float)


func _add_label(grid: GridContainer, text: String, width: int, variation: StringName) -> Label:
	var label := Label.new()
	label.text = text
	label.custom_minimum_size.x = width
	label.theme_type_variation = variation
	grid.add_child(label)
	return label


func _add_number(grid: GridContainer) -> Label:
	var label := _add_label(grid, "", NUMBER_WIDTH, &"Label")
	label.add_theme_font_size_override(&"font_size", 12)
	label.horizontal_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	label.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	return label


func _make_pair_label(pair: Vector2i) -> RichTextLabel:
	var label := RichTextLabel.new()
	label.bbcode_enabled = true
	label.fit_content = true
	label.autowrap_mode = TextServer.AUTOWRAP_OFF
	label.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	label.add_theme_font_size_override(&"normal_font_size", 12)
	label.text = (
		"[color=#%s]%s[/color] [color=#8c96a8]to[/color] [color=#%s]%s[/color]"
		% [
			Modes.COLORS[pair.x].to_html(false),
			Modes.TITLES[pair.x],
			Modes.COLORS[pair.y].to_html(false),
			Modes.TITLES[pair.y],
		]
	)
	return label


## Four decimals, with a minus sign as wide as a digit and no "-0".
func _format(number: float) -> String:
	if absf(number) < 5e-5:
		return "0"
	return ("%.4f" % number).replace("-", "−")
