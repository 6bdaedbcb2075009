extends VBoxContainer
## Sliders for one pose: position, rotation and scale.

## Emitted when the user moves a slider, not by show_pose().
signal pose_changed

const DemoPose := preload("res://demos/interpolation/demo_pose.gd")

const NAME_WIDTH := 66
const VALUE_WIDTH := 52
## Largest coordinate of a position, in meters.
const MAX_POSITION := 4.0
const MIN_SCALE := 0.5
const MAX_SCALE := 2.5
const ROW_NAMES: Array[String] = ["Position x", "y", "z", "Rotation x", "y", "z", "Scale"]

var _pose := DemoPose.new()
var _sliders: Array[HSlider] = []
var _values: Array[Label] = []


func _init() -> void:
	add_theme_constant_override(&"separation", 2)
	for i in 3:
		_add_row(ROW_NAMES[i], -MAX_POSITION, MAX_POSITION, 0.01)
	for i in range(3, 6):
		_add_row(ROW_NAMES[i], -180.0, 180.0, 1.0)
	_add_row(ROW_NAMES[6], MIN_SCALE, MAX_SCALE, 0.01)


func get_pose() -> DemoPose:
	return _pose


## Shows a copy of the pose without emitting pose_changed.
func show_pose(pose: DemoPose) -> void:
	_pose = pose.duplicate_pose()
	var numbers: Array[float] = [
		pose.position.x,
		pose.position.y,
		pose.position.z,
		pose.rotation_degrees.x,
		pose.rotation_degrees.y,
		pose.rotation_degrees.z,
		pose.scale,
	]
	for i in numbers.size():
		_sliders[i].set_value_no_signal(numbers[i])
		_show_value(i)


func _add_row(row_name: String, min_value: float, max_value: float, step: float) -> void:
	var index := _sliders.size()
	var row := HBoxContainer.new()
	row.add_theme_constant_override(&"separation", 8)

	var label := Label.new()
	label.text = row_name
	label.theme_type_variation = &"CaptionLabel"
	label.custom_minimum_size.x = NAME_WIDTH
	label.horizontal_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	row.add_child(label)

	var slider := HSlider.new()
	slider.min_value = min_value
	slider.max_value = max_value
	slider.step = step
	slider.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	slider.size_flags_vertical = Control.SIZE_SHRINK_CENTER
	slider.value_changed.connect(_on_slider_moved.bind(index))
	row.add_child(slider)

	var value := Label.new()
	value.custom_minimum_size.x = VALUE_WIDTH
	value.theme_type_variation = &"CaptionLabel"
	value.horizontal_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	row.add_child(value)

	_sliders.append(slider)
	_values.append(value)
	add_child(row)


func _on_slider_moved(_value: float, index: int) -> void:
	_pose.position = Vector3(_sliders[0].value, _sliders[1].value, _sliders[2].value)
	_pose.rotation_degrees = Vector3(_sliders[3].value, _sliders[4].value, _sliders[5].value)
	_pose.scale = _sliders[6].value
	_show_value(index)
	pose_changed.emit()


func _show_value(index: int) -> void:
	var number := _sliders[index].value
	if index < 3:
		_values[index].text = "%.2f m" % number
	elif index < 6:
		_values[index].text = "%d°" % roundi(number)
	else:
		_values[index].text = "%.2f" % number
