@tool
extends Node3D
## The way between two poses in one mode: ghosts of a body at even steps, the path of its origin, and the body at t.
## Ghosts and path are one MotorPool: all have the same two poses, and a weight each.

const Modes := preload("interpolation_modes.gd")
const LabBody := preload("lab_body.gd")
const PathRibbon := preload("path_ribbon.gd")
const RIBBON_SHADER := preload("path_ribbon.gdshader")

const PATH_POINTS := 65
## A row of the pool's buffer: three rows of a 3x4 matrix, the origin in the last column.
const FLOATS_PER_BODY := 12

var mode: MultivectorLerp.Mode

var _body_kind := &""
var _ghost_count := 0
var _from := Transform3D.IDENTITY
var _to := Transform3D.IDENTITY
var _pool := MotorPool.new()
var _weights := PackedFloat32Array()
var _multimesh := MultiMesh.new()
var _ghosts := MultiMeshInstance3D.new()
var _ribbon := ArrayMesh.new()
var _path := MeshInstance3D.new()
var _body := MeshInstance3D.new()


func _init(p_mode: MultivectorLerp.Mode = MultivectorLerp.LINEAR) -> void:
	mode = p_mode
	name = Modes.TITLES[mode]
	_multimesh.transform_format = MultiMesh.TRANSFORM_3D
	_ghosts.name = "Ghosts"
	_ghosts.multimesh = _multimesh
	_path.name = "Path"
	_path.mesh = _ribbon
	var material := ShaderMaterial.new()
	material.shader = RIBBON_SHADER
	material.set_shader_parameter(&"color", Modes.COLORS[mode])
	_path.material_override = material
	_body.name = "Body"
	for part: GeometryInstance3D in [_ghosts, _path, _body]:
		part.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
		add_child(part)
	_set_ghost_count(0)


## What of it is drawn: no ghosts are 0 of them.
func set_style(body_kind: StringName, ghost_count: int, with_path: bool) -> void:
	if body_kind != _body_kind:
		_body_kind = body_kind
		_body.mesh = LabBody.solid(body_kind, Modes.COLORS[mode])
		_multimesh.mesh = LabBody.ghost(body_kind, Modes.COLORS[mode])
	if ghost_count != _ghost_count:
		_set_ghost_count(ghost_count)
	_ghosts.visible = ghost_count > 0
	_path.visible = with_path


func show_poses(from: Transform3D, to: Transform3D) -> void:
	_from = from
	_to = to
	var ends: Array[Transform3D] = []
	ends.resize(_weights.size())
	ends.fill(from)
	_pool.set_from_all(ends)
	ends.fill(to)
	_pool.set_to_all(ends)
	_pool.interpolate_each(_weights, mode)
	var buffer := _pool.get_buffer()
	if _ghost_count > 0:
		_multimesh.buffer = buffer.slice(0, _ghost_count * FLOATS_PER_BODY)
	if _path.visible:
		var centers := PackedVector3Array()
		for row in range(_ghost_count * FLOATS_PER_BODY, buffer.size(), FLOATS_PER_BODY):
			centers.append(Vector3(buffer[row + 3], buffer[row + 7], buffer[row + 11]))
		PathRibbon.build(_ribbon, centers)


func show_moment(t: float) -> void:
	_body.transform = MultivectorLerp.interpolate_transform(_from, _to, t, mode)


func get_body() -> MeshInstance3D:
	return _body


func get_ghosts() -> MultiMesh:
	return _multimesh


func get_path_mesh() -> ArrayMesh:
	return _ribbon


func _set_ghost_count(count: int) -> void:
	_ghost_count = count
	_multimesh.instance_count = count
	_pool = MotorPool.new()
	_pool.reserve(count + PATH_POINTS)
	_weights = PackedFloat32Array()
	for i in count:
		_weights.append(float(i) / (count - 1))
	for i in PATH_POINTS:
		_weights.append(float(i) / (PATH_POINTS - 1))
	for i in _weights.size():
		_pool.acquire()
