extends Node3D
## The camera, which orbits a point near the player's ball. Right drag rotates, the wheel zooms.

const ROTATION_SPEED := 0.006
const ZOOM_STEP := 1.1
const FOLLOW_SPEED := 2.5
## Weight of the ball's position in the point that the camera orbits; the rest is the center of the
## arena.
const FOLLOW_SHARE := 0.3
## Width of the area, in heights of the window, in which the whole arena is visible at the initial
## distance.
const FITTING_ASPECT := 1.7
## Distance of the point that the camera orbits above the middle of the area, in heights of the
## window: the near half of the arena looks larger than the far one.
const RAISE := 0.03
## Initial azimuth in radians.
const YAW := 0.5

var camera := Camera3D.new()
var yaw := YAW
var pitch := -0.52
var distance: float
## Height of the point that the camera orbits, in meters.
var height := 0.0
## Position of the player's ball, or the center of the arena.
var target := Vector3.ZERO
## The part of the window that no panel covers, as a share of its size. The camera shows the arena
## in its middle, and completely unless the player zooms in.
var free_area := Rect2(0.0, 0.0, 1.0, 1.0)


func _init(half_extent: float) -> void:
	distance = half_extent * 2.2
	camera.fov = 42.0
	camera.far = 300.0
	add_child(camera)


func _ready() -> void:
	_place()


func _process(delta: float) -> void:
	var goal := target * FOLLOW_SHARE
	goal.y = height
	position = position.lerp(goal, 1.0 - exp(-FOLLOW_SPEED * delta))
	_place()


func _unhandled_input(event: InputEvent) -> void:
	var motion := event as InputEventMouseMotion
	if motion != null and motion.button_mask & MOUSE_BUTTON_MASK_RIGHT:
		yaw -= motion.relative.x * ROTATION_SPEED
		pitch = clampf(pitch - motion.relative.y * ROTATION_SPEED, -1.4, -0.1)
	var button := event as InputEventMouseButton
	if button != null and button.pressed:
		if button.button_index == MOUSE_BUTTON_WHEEL_UP:
			distance = maxf(distance / ZOOM_STEP, 4.0)
		elif button.button_index == MOUSE_BUTTON_WHEEL_DOWN:
			distance = minf(distance * ZOOM_STEP, 80.0)


func _place() -> void:
	var rotation_basis := Basis(Vector3.UP, yaw) * Basis(Vector3.RIGHT, pitch)
	var size := get_viewport().get_visible_rect().size
	var aspect := size.x / size.y
	var away := distance * maxf(FITTING_ASPECT / (aspect * free_area.size.x), 1.0)
	camera.transform = Transform3D(rotation_basis, rotation_basis * Vector3(0.0, 0.0, away))
	var view_height := 2.0 * away * tan(deg_to_rad(camera.fov) * 0.5)
	var center := free_area.get_center()
	camera.h_offset = (0.5 - center.x) * view_height * aspect
	camera.v_offset = (center.y - 0.5 - RAISE) * view_height
