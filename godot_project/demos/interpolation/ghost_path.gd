extends Node3D
## The path of the cube in one mode: ghost cubes at equal steps of the factor and a ribbon through
## their centers. The ghosts are a MotorPool whose bodies share the two poses and differ in weight.

const CubeMesh := preload("res://addons/ga_godot/playground/lab/cube_mesh.gd")
const Modes := preload("res://addons/ga_godot/playground/lab/interpolation_modes.gd")
const PathRibbon := preload("res://addons/ga_godot/playground/lab/path_ribbon.gd")

const GHOSTS := 9
const LINE_POINTS := 97
## Size of a body in the pool's buffer: the rows of a 3x4 matrix, with the origin in the last
## column.
const FLOATS_PER_BODY := 12
const EDGE_THICKNESS := 0.016
## Opacities in the chosen mode and in the others.
const CHOSEN_GHOST_ALPHA := 0.6
const OTHER_GHOST_ALPHA := 0.22
const CHOSEN_LINE_ALPHA := 1.0
const OTHER_LINE_ALPHA := 0.5

var _mode := MultivectorLerp.LINEAR
var _pool := MotorPool.new()
var _line_pool := MotorPool.new()
var _ghosts := MultiMesh.new()
var _line := ArrayMesh.new()
var _ghost_weights := PackedFloat32Array()
var _line_weights := PackedFloat32Array()
var _ghost_material := _make_material()
var _line_material := PathRibbon.make_material(Color.WHITE)


func _init(mode: MultivectorLerp.Mode = MultivectorLerp.LINEAR) -> void:
	_mode = mode
	name = Modes.TITLES[mode]
	_ghost_weights = _fill(_pool, GHOSTS)
	_line_weights = _fill(_line_pool, LINE_POINTS)


func _ready() -> void:
	set_chosen(false)

	_ghosts.transform_format = MultiMesh.TRANSFORM_3D
	_ghosts.mesh = CubeMesh.edges(EDGE_THICKNESS)
	_ghosts.instance_count = GHOSTS
	var instance := MultiMeshInstance3D.new()
	instance.name = "Ghosts"
	instance.multimesh = _ghosts
	instance.material_override = _ghost_material
	instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	# The engine updates the bounds of a MultiMesh too late, so use a box around the whole scene.
	instance.custom_aabb = AABB(Vector3.ONE * -50.0, Vector3.ONE * 100.0)
	add_child(instance)

	var ribbon := MeshInstance3D.new()
	ribbon.name = "Line"
	ribbon.mesh = _line
	ribbon.material_override = _line_material
	ribbon.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	add_child(ribbon)


## Draws the path between two poses.
func show_path(from: Transform3D, to: Transform3D) -> void:
	_interpolate(_pool, from, to, _ghost_weights)
	_pool.apply_to_multimesh(_ghosts)

	_interpolate(_line_pool, from, to, _line_weights)
	var buffer := _line_pool.get_buffer()
	var centers := PackedVector3Array()
	for row in range(0, buffer.size(), FLOATS_PER_BODY):
		centers.append(Vector3(buffer[row + 3], buffer[row + 7], buffer[row + 11]))
	PathRibbon.build(_line, centers)


## Highlights the path of the chosen mode.
func set_chosen(chosen: bool) -> void:
	var color := Modes.COLORS[_mode]
	_ghost_material.albedo_color = Color(color, CHOSEN_GHOST_ALPHA if chosen else OTHER_GHOST_ALPHA)
	_line_material.set_shader_parameter(
		&"color", Color(color, CHOSEN_LINE_ALPHA if chosen else OTHER_LINE_ALPHA)
	)
	_ghost_material.render_priority = 1 if chosen else 0
	_line_material.render_priority = 1 if chosen else 0


func _make_material() -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	return material


## Adds `count` bodies to an empty pool and returns their weights, evenly spaced from 0 to 1.
func _fill(pool: MotorPool, count: int) -> PackedFloat32Array:
	var weights := PackedFloat32Array()
	pool.reserve(count)
	for i in count:
		pool.acquire()
		weights.append(float(i) / (count - 1))
	return weights


func _interpolate(
	pool: MotorPool, from: Transform3D, to: Transform3D, weights: PackedFloat32Array
) -> void:
	var ends: Array[Transform3D] = []
	ends.resize(weights.size())
	ends.fill(from)
	pool.set_from_all(ends)
	ends.fill(to)
	pool.set_to_all(ends)
	pool.interpolate_each(weights, _mode)
