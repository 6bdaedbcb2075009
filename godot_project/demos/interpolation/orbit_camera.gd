extends Node3D
## A camera that circles a point: drag turns it, the wheel or a pinch brings it closer.

const TURN_SPEED := 0.008
const ZOOM_STEP := 1.1
const NEAREST := 2.5
const FARTHEST := 20.0
const STEEPEST := 1.5

@export var yaw_degrees := -24.0
@export var pitch_degrees := 24.0
@export var distance := 7.4

var _yaw := 0.0
var _pitch := 0.0
var _distance := 0.0

@onready var _camera: Camera3D = $Camera3D


func _ready() -> void:
	reset()


## Back to the exported angles and distance.
func reset() -> void:
	_yaw = deg_to_rad(yaw_degrees)
	_pitch = deg_to_rad(pitch_degrees)
	_distance = distance
	_apply()


func _unhandled_input(event: InputEvent) -> void:
	var motion := event as InputEventMouseMotion
	if motion != null and motion.button_mask & (MOUSE_BUTTON_MASK_LEFT | MOUSE_BUTTON_MASK_RIGHT) != 0:
		_yaw -= motion.relative.x * TURN_SPEED
		_pitch = clampf(_pitch + motion.relative.y * TURN_SPEED, -STEEPEST, STEEPEST)
		_apply()
	var button := event as InputEventMouseButton
	if button != null and button.pressed:
		if button.button_index == MOUSE_BUTTON_WHEEL_UP:
			_zoom(1.0 / ZOOM_STEP)
		elif button.button_index == MOUSE_BUTTON_WHEEL_DOWN:
			_zoom(ZOOM_STEP)
	var pinch := event as InputEventMagnifyGesture
	if pinch != null:
		_zoom(1.0 / pinch.factor)


func _zoom(factor: float) -> void:
	_distance = clampf(_distance * factor, NEAREST, FARTHEST)
	_apply()


func _apply() -> void:
	rotation = Vector3(-_pitch, _yaw, 0.0)
	_camera.position = Vector3(0.0, 0.0, _distance)
