extends Node3D
## A grid in the plane y = 0, and the axes. Spacing and extent follow the distance of the camera.

const OrbitCamera := preload("res://demos/shared/orbit_camera.gd")

## Lengths in units of the distance of the camera.
const REACH := 6.0
const FADE_BEGIN := 1.5
const SPACING_SHARE := 0.6
const FINE_STRENGTH := 0.16
const Y_AXIS_COLOR := Color(0.38, 0.72, 0.3)
## Colors of the ground and of its lines.
const DARK: Array[Color] = [Color(0.085, 0.098, 0.124), Color(0.4, 0.45, 0.54)]
const LIGHT: Array[Color] = [Color(0.93, 0.938, 0.953), Color(0.55, 0.59, 0.66)]

@onready var _floor: MeshInstance3D = $Floor
@onready var _y_axis: MeshInstance3D = $YAxis


func _ready() -> void:
	_floor.mesh = PlaneMesh.new()
	var line := ImmediateMesh.new()
	line.surface_begin(Mesh.PRIMITIVE_LINES)
	line.surface_set_color(Color(Y_AXIS_COLOR, 0.8))
	line.surface_add_vertex(Vector3.ZERO)
	line.surface_set_color(Color(Y_AXIS_COLOR, 0.0))
	line.surface_add_vertex(Vector3.UP)
	line.surface_end()
	_y_axis.mesh = line


func set_light(light: bool) -> void:
	_material().set_shader_parameter(&"ground_color", (LIGHT if light else DARK)[0])
	_material().set_shader_parameter(&"line_color", (LIGHT if light else DARK)[1])


func fit_to(view: OrbitCamera) -> void:
	var distance := view.get_distance()
	var power := log(distance * SPACING_SHARE) / log(10.0)
	var spacing := pow(10.0, floorf(power))
	var center := Vector3(view.position.x, 0.0, view.position.z)
	_floor.position = center
	_floor.scale = Vector3.ONE * distance * REACH
	_y_axis.scale = Vector3.ONE * distance
	_material().set_shader_parameter(&"center", Vector2(center.x, center.z))
	_material().set_shader_parameter(&"coarse_spacing", spacing)
	_material().set_shader_parameter(&"fine_spacing", spacing / 10.0)
	# The fine lines fade out before the coarse lines replace them.
	_material().set_shader_parameter(
		&"fine_strength", FINE_STRENGTH * (1.0 - (power - floorf(power)))
	)
	_material().set_shader_parameter(&"fade_begin", distance * FADE_BEGIN)
	_material().set_shader_parameter(&"fade_end", distance * REACH)


func _material() -> ShaderMaterial:
	return _floor.material_override
