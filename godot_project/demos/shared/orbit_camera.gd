extends Node3D
## A camera that orbits a point: dragging rotates or pans it, the wheel or a pinch gesture zooms.

signal moved

const ROTATION_SPEED := 0.008
const ZOOM_STEP := 1.1
## Maximum pitch in radians, up and down.
const MAX_PITCH := 1.5
## Mouse pixels per unit of a pan gesture.
const PAN_GESTURE := 12.0

@export var yaw_degrees := -24.0
@export var pitch_degrees := 24.0
@export var distance := 7.4
@export var nearest := 2.5
@export var farthest := 20.0
@export_flags("Left:1", "Right:2", "Middle:4")
var rotating_buttons := MOUSE_BUTTON_MASK_LEFT | MOUSE_BUTTON_MASK_RIGHT
## Buttons that pan parallel to the view plane. If there are any, dragging with
## Shift and a rotating button also pans.
@export_flags("Left:1", "Right:2", "Middle:4") var panning_buttons := 0

var _yaw := 0.0
var _pitch := 0.0
var _distance := 0.0

@onready var camera: Camera3D = $Camera3D


func _ready() -> void:
	reset()


## Returns to the exported angles and distance.
func reset() -> void:
	_yaw = deg_to_rad(yaw_degrees)
	_pitch = deg_to_rad(pitch_degrees)
	_distance = distance
	_apply()


## Moves to [param from], clamped to the allowed distances, and looks at a point.
func look_from(from: Vector3, at: Vector3) -> void:
	var offset := from - at
	position = at
	_distance = clampf(offset.length(), nearest, farthest)
	_yaw = atan2(offset.x, offset.z)
	_pitch = clampf(
		asin(clampf(offset.y / maxf(offset.length(), 1e-6), -1.0, 1.0)), -MAX_PITCH, MAX_PITCH
	)
	_apply()


## Keeps the direction of view and fits a sphere into the view.
func frame(center: Vector3, radius: float) -> void:
	position = center
	_distance = clampf(radius / sin(deg_to_rad(camera.fov) / 2.0), nearest, farthest)
	_apply()


func get_distance() -> float:
	return _distance


func _unhandled_input(event: InputEvent) -> void:
	var motion := event as InputEventMouseMotion
	if motion != null and motion.button_mask & (rotating_buttons | panning_buttons) != 0:
		var with_shift := motion.shift_pressed and panning_buttons != 0
		_drag(motion.relative, with_shift or motion.button_mask & panning_buttons != 0)
	var button := event as InputEventMouseButton
	if button != null and button.pressed:
		if button.button_index == MOUSE_BUTTON_WHEEL_UP:
			_zoom(1.0 / ZOOM_STEP)
		elif button.button_index == MOUSE_BUTTON_WHEEL_DOWN:
			_zoom(ZOOM_STEP)
	var pinch := event as InputEventMagnifyGesture
	if pinch != null:
		_zoom(1.0 / pinch.factor)
	var pan := event as InputEventPanGesture
	if pan != null:
		_drag(-pan.delta * PAN_GESTURE, pan.shift_pressed and panning_buttons != 0)


func _drag(pixels: Vector2, pans: bool) -> void:
	if pans:
		var height := camera.get_viewport().get_visible_rect().size.y
		var unit := 2.0 * _distance * tan(deg_to_rad(camera.fov) / 2.0) / height
		position += basis * Vector3(-pixels.x, pixels.y, 0.0) * unit
	else:
		_yaw -= pixels.x * ROTATION_SPEED
		_pitch = clampf(_pitch + pixels.y * ROTATION_SPEED, -MAX_PITCH, MAX_PITCH)
	_apply()


func _zoom(factor: float) -> void:
	_distance = clampf(_distance * factor, nearest, farthest)
	_apply()


func _apply() -> void:
	rotation = Vector3(-_pitch, _yaw, 0.0)
	camera.position = Vector3(0.0, 0.0, _distance)
	moved.emit()
