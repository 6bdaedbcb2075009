@tool
extends Node3D
## Draws one interpolation mode: ghosts of a body at equal steps, the path of its origin, and the
## body at t. Takes motors rather than transforms, because the sign of a motor determines the
## direction of a rotation by 180°.

const Modes := preload("interpolation_modes.gd")
const LabBody := preload("lab_body.gd")
const PathRibbon := preload("path_ribbon.gd")

const PATH_POINTS := 65

var mode: MultivectorLerp.Mode

var _body_kind := &""
var _ghost_count := 0
var _from: Multivector
var _to: Multivector
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
	_path.material_override = PathRibbon.make_material(Modes.COLORS[mode])
	_body.name = "Body"
	for part: GeometryInstance3D in [_ghosts, _path, _body]:
		part.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
		add_child(part)


## A ghost count of 0 hides the ghosts.
func set_style(body_kind: StringName, ghost_count: int, with_path: bool) -> void:
	if body_kind != _body_kind:
		_body_kind = body_kind
		_body.mesh = LabBody.solid(body_kind, Modes.COLORS[mode])
		_multimesh.mesh = LabBody.ghost(body_kind, Modes.COLORS[mode])
	if ghost_count != _ghost_count:
		_ghost_count = ghost_count
		_multimesh.instance_count = ghost_count
	_ghosts.visible = ghost_count > 0
	_path.visible = with_path


func show_poses(from: Multivector, to: Multivector) -> void:
	_from = from
	_to = to
	if _ghosts.visible:
		_multimesh.buffer = _ghost_rows()
	if _path.visible:
		var centers := PackedVector3Array()
		for i in PATH_POINTS:
			centers.append(_pose_at(float(i) / (PATH_POINTS - 1)).get_translation())
		PathRibbon.build(_ribbon, centers)


func show_t(t: float) -> void:
	_body.transform = _pose_at(t).to_transform()


func get_body() -> MeshInstance3D:
	return _body


func get_ghosts() -> MultiMesh:
	return _multimesh


func get_path_mesh() -> ArrayMesh:
	return _ribbon


func _pose_at(t: float) -> Multivector:
	return MultivectorLerp.interpolate(_from, _to, t, mode)


# Each transform as the three rows of a 3x4 matrix, the layout of MultiMesh.buffer.
func _ghost_rows() -> PackedFloat32Array:
	var rows := PackedFloat32Array()
	for i in _ghost_count:
		var pose := _pose_at(float(i) / (_ghost_count - 1)).to_transform()
		for axis in 3:
			rows.append(pose.basis.x[axis])
			rows.append(pose.basis.y[axis])
			rows.append(pose.basis.z[axis])
			rows.append(pose.origin[axis])
	return rows
