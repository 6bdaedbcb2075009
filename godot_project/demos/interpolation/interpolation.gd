extends Node3D
## The interpolation demo: a cube between two poses, in three modes. A MultivectorLerp node moves
## the cube; ghost_path.gd draws the paths with MotorPools.

const ControlPanel := preload("res://demos/interpolation/control_panel.gd")
const CubeMesh := preload("res://addons/ga_godot/playground/lab/cube_mesh.gd")
const GhostPath := preload("res://demos/interpolation/ghost_path.gd")
const Legend := preload("res://demos/interpolation/legend.gd")
const Modes := preload("res://addons/ga_godot/playground/lab/interpolation_modes.gd")
const OrbitCamera := preload("res://demos/shared/orbit_camera.gd")
const PlayBar := preload("res://demos/interpolation/play_bar.gd")
const ReadoutPanel := preload("res://demos/interpolation/readout_panel.gd")

const FIRST_FACTOR := 0.4
const EDGE_THICKNESS := 0.022
## Opacity of the start and end cubes.
const POSE_ALPHA := 0.55
const KEY_MODES: Dictionary[Key, int] = {KEY_1: 0, KEY_2: 1, KEY_3: 2}

var _paths: Array[GhostPath] = []
var _cube_edges := StandardMaterial3D.new()
var _start_motor: Multivector
var _end_motor: Multivector

@onready var _start: MeshInstance3D = $Start
@onready var _end: MeshInstance3D = $End
@onready var _cube: MeshInstance3D = $Cube
@onready var _lerp: MultivectorLerp = $Lerp
@onready var _camera: OrbitCamera = $OrbitCamera
@onready var _panels: MarginContainer = $Interface/Panels
@onready var _control_panel: ControlPanel = %ControlPanel
@onready var _readout_panel: ReadoutPanel = %ReadoutPanel
@onready var _play_bar: PlayBar = %PlayBar
@onready var _legend: Legend = %Legend


func _ready() -> void:
	_build_cubes()
	for mode in Modes.COUNT:
		var path := GhostPath.new(mode as MultivectorLerp.Mode)
		$Paths.add_child(path)
		_paths.append(path)
	_control_panel.mode_chosen.connect(choose_mode)
	_control_panel.poses_changed.connect(_on_poses_changed)
	_play_bar.factor_changed.connect(_on_factor_changed)
	_legend.path_toggled.connect(_on_path_toggled)
	choose_preset(0)
	choose_mode(MultivectorLerp.SCREW)
	set_factor(FIRST_FACTOR)


## Handles Space before the focused button does.
func _input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if key != null and key.pressed and not key.echo and key.keycode == KEY_SPACE:
		set_playing(not _play_bar.is_playing())
		get_viewport().set_input_as_handled()


func _unhandled_key_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if key == null or not key.pressed or key.echo:
		return
	if KEY_MODES.has(key.keycode):
		choose_mode(KEY_MODES[key.keycode] as MultivectorLerp.Mode)
	elif key.keycode == KEY_H:
		show_panels(not _panels.visible)
	elif key.keycode == KEY_R:
		_camera.reset()
	else:
		return
	get_viewport().set_input_as_handled()


func choose_mode(mode: MultivectorLerp.Mode) -> void:
	_lerp.mode = mode
	_control_panel.show_mode(mode)
	_cube_edges.albedo_color = Modes.COLORS[mode]
	for i in _paths.size():
		_paths[i].set_chosen(i == mode)
	_on_factor_changed(_play_bar.get_factor())


## Chooses a preset by its index in presets.gd.
func choose_preset(index: int) -> void:
	_control_panel.choose_preset(index)


func set_factor(factor: float) -> void:
	_play_bar.set_factor(factor)


func set_playing(playing: bool) -> void:
	_play_bar.set_playing(playing)


func show_panels(shown: bool) -> void:
	_panels.visible = shown


## The moving cube.
func get_cube() -> MeshInstance3D:
	return _cube


func _build_cubes() -> void:
	var faces := StandardMaterial3D.new()
	faces.vertex_color_use_as_albedo = true
	faces.vertex_color_is_srgb = true
	faces.roughness = 0.55
	_cube_edges.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	var pose_edges := StandardMaterial3D.new()
	pose_edges.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	pose_edges.albedo_color = Color(0.8, 0.84, 0.9)
	var faint := faces.duplicate() as StandardMaterial3D
	faint.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	faint.albedo_color.a = POSE_ALPHA
	_set_up_cube(_cube, faces, _cube_edges)
	_set_up_cube(_start, faint, pose_edges)
	_set_up_cube(_end, faint, pose_edges)
	_add_caption(_start, "Start")
	_add_caption(_end, "End")


func _set_up_cube(cube: MeshInstance3D, faces: Material, edges: Material) -> void:
	cube.mesh = CubeMesh.solid()
	cube.material_override = faces
	var frame := MeshInstance3D.new()
	frame.mesh = CubeMesh.edges(EDGE_THICKNESS)
	frame.material_override = edges
	frame.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	cube.add_child(frame)


func _add_caption(cube: MeshInstance3D, text: String) -> void:
	var caption := Label3D.new()
	caption.name = "Caption"
	caption.text = text
	caption.billboard = BaseMaterial3D.BILLBOARD_ENABLED
	caption.no_depth_test = true
	caption.fixed_size = true
	caption.pixel_size = 0.0008
	caption.font_size = 28
	caption.outline_size = 8
	caption.outline_modulate = Color(0.071, 0.082, 0.106, 0.8)
	caption.top_level = true
	cube.add_child(caption)


func _place_caption(cube: MeshInstance3D) -> void:
	var caption: Label3D = cube.get_node(^"Caption")
	var size := cube.transform.basis.get_scale().x * CubeMesh.EDGE
	caption.global_position = cube.global_position + Vector3.UP * (0.66 * size + 0.16)


func _on_poses_changed() -> void:
	_start.transform = _control_panel.get_start_pose().to_transform()
	_end.transform = _control_panel.get_end_pose().to_transform()
	_start_motor = Multivector.motor(_start.transform)
	_end_motor = Multivector.motor(_end.transform)
	_place_caption(_start)
	_place_caption(_end)
	for path in _paths:
		path.show_path(_start.transform, _end.transform)
	_readout_panel.show_deviations(_start_motor, _end_motor)
	_on_factor_changed(_play_bar.get_factor())


func _on_factor_changed(factor: float) -> void:
	_lerp.factor = factor
	_readout_panel.show_motor(
		MultivectorLerp.interpolate(_start_motor, _end_motor, factor, _lerp.mode)
	)


func _on_path_toggled(mode: int, shown: bool) -> void:
	_paths[mode].visible = shown
