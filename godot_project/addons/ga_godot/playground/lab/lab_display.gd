@tool
extends HFlowContainer
## Display settings: body, path, ghosts, the lever arm of deviations, and the duration of playback.

const PlaygroundHost := preload("../playground_host.gd")
const InterpolationLab := preload("interpolation_lab.gd")
const LabBody := preload("lab_body.gd")
const LabNumber := preload("lab_number.gd")

const LEVER_ARM_HINT := (
	"Lever arm, in meters. Deviations are measured at the points of the body that are this far from"
	+ " its origin."
)

var _lab: InterpolationLab
var _body := OptionButton.new()
var _ghosts: CheckBox
var _path: CheckBox
var _count: LabNumber
var _lever_arm: LabNumber
var _duration: LabNumber


func _init(lab: InterpolationLab, host: PlaygroundHost) -> void:
	name = "Shown"
	_lab = lab
	_body.name = "Body"
	_body.tooltip_text = "Choose the body to draw."
	for kind in LabBody.KINDS:
		_body.add_item(LabBody.TITLES[kind])
	_body.item_selected.connect(
		func(index: int) -> void: _lab.set_setting(&"body", String(LabBody.KINDS[index]))
	)
	_path = _make_box(&"path", "Path", "Draw the path of the body's origin.")
	_ghosts = _make_box(&"ghosts", "Ghosts", "Draw the body at equal steps of t.")
	_count = LabNumber.new(
		lab, host, &"ghost_count", "", 1.0, "Number of ghosts, including both ends."
	)
	_lever_arm = LabNumber.new(lab, host, &"lever_arm", "lever arm", 0.01, LEVER_ARM_HINT)
	_duration = LabNumber.new(
		lab,
		host,
		&"duration",
		"time",
		0.1,
		"Duration of the playback from one pose to the other, in seconds."
	)
	for part: Control in [_body, _path, _ghosts, _count, _lever_arm, _duration]:
		add_child(part)


func refresh() -> void:
	_body.selected = LabBody.KINDS.find(StringName(_lab.get_setting(&"body") as String))
	_path.set_pressed_no_signal(_lab.get_setting(&"path") as bool)
	_ghosts.set_pressed_no_signal(_lab.get_setting(&"ghosts") as bool)
	_count.visible = _ghosts.button_pressed
	_count.refresh()
	_lever_arm.refresh()
	_duration.refresh()


func _make_box(key: StringName, title: String, hint: String) -> CheckBox:
	var box := CheckBox.new()
	box.name = title
	box.text = title
	box.tooltip_text = hint
	box.toggled.connect(func(on: bool) -> void: _lab.set_setting(key, on))
	return box
