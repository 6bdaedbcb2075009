@tool
extends RefCounted
## A view of a document, stored as scene attributes: "view/from" and "view/to" are positions,
## written as three numbers separated by commas, "view/fov" is the vertical field of view in
## degrees, and "view/background" the background color.

const ViewPoint := preload("view_point.gd")

const FROM := "view/from"
const TO := "view/to"
const FOV := "view/fov"
const BACKGROUND := "view/background"

const DEFAULT_FROM := Vector3(4.0, 3.0, 7.0)
const DEFAULT_TO := Vector3(0.0, 0.5, 0.0)
const DEFAULT_FOV := 40.0
const DEFAULT_BACKGROUND := Color(0.075, 0.086, 0.11)
const MIN_FOV := 1.0
const MAX_FOV := 150.0
## The aspect ratio that documents are arranged for.
const REFERENCE_ASPECT := 16.0 / 9.0

var from := DEFAULT_FROM
var to := DEFAULT_TO
var fov := DEFAULT_FOV
var background := DEFAULT_BACKGROUND


## The view stored in a document, with defaults for missing or invalid attributes.
static func of(scene: GAScene) -> ViewPoint:
	var view := ViewPoint.new()
	view.from = _read_position(scene.get_scene_attribute(FROM), DEFAULT_FROM)
	view.to = _read_position(scene.get_scene_attribute(TO), DEFAULT_TO)
	if view.from.is_equal_approx(view.to):
		view.from = view.to + DEFAULT_FROM - DEFAULT_TO
	var angle: Variant = scene.get_scene_attribute(FOV)
	if angle is float:
		view.fov = clampf(angle, MIN_FOV, MAX_FOV)
	var color: Variant = scene.get_scene_attribute(BACKGROUND)
	if color is String:
		view.background = Color.from_string(color, DEFAULT_BACKGROUND)
	return view


## The view of a camera that looks at a point at this distance.
static func of_camera(camera: Camera3D, distance: float) -> ViewPoint:
	var view := ViewPoint.new()
	view.from = camera.global_position
	view.to = view.from - camera.global_basis.z.normalized() * maxf(distance, 0.001)
	view.fov = camera.fov
	return view


## Whether a document stores a view.
static func is_stored_in(scene: GAScene) -> bool:
	return scene.get_scene_attribute(FROM) != null


## Stores the view in a document.
func write_to(scene: GAScene) -> void:
	scene.set_scene_attribute(FROM, _write_position(from))
	scene.set_scene_attribute(TO, _write_position(to))
	scene.set_scene_attribute(FOV, snappedf(fov, 0.01))


## Sets up a camera in the same space as the drawing.
func apply_to(camera: Camera3D) -> void:
	camera.transform = get_transform()
	camera.fov = fov


## The vertical field of view for a viewport of this size: one that is narrower than
## REFERENCE_ASPECT shows the same width as at REFERENCE_ASPECT.
func fov_in(size: Vector2) -> float:
	var narrowing := REFERENCE_ASPECT * size.y / maxf(size.x, 1.0)
	if narrowing <= 1.0:
		return fov
	return clampf(rad_to_deg(2.0 * atan(tan(deg_to_rad(fov) / 2.0) * narrowing)), MIN_FOV, MAX_FOV)


func get_transform() -> Transform3D:
	var is_vertical := (to - from).normalized().abs().is_equal_approx(Vector3.UP)
	return Transform3D(Basis(), from).looking_at(to, Vector3.FORWARD if is_vertical else Vector3.UP)


static func _read_position(text: Variant, fallback: Vector3) -> Vector3:
	if not text is String:
		return fallback
	var numbers := (text as String).split(",")
	if numbers.size() != 3:
		return fallback
	for number in numbers:
		if not number.strip_edges().is_valid_float():
			return fallback
	var point := Vector3(numbers[0].to_float(), numbers[1].to_float(), numbers[2].to_float())
	return point if point.is_finite() else fallback


static func _write_position(point: Vector3) -> String:
	var numbers := PackedStringArray()
	for axis in 3:
		numbers.append(String.num(point[axis], 3))
	return ", ".join(numbers)
