extends Node3D
## A player's ball on a client, with the player's name above it.

const Palette := preload("palette.gd")
const PlayerBall := preload("../world/player_ball.gd")
const Scenario := preload("../world/scenario.gd")

const LABEL_GAP := 0.55

var _ball := MeshInstance3D.new()
var _label := Label3D.new()
var _radius: float


func _init(scene: String, slot: int, player_name: String) -> void:
	_radius = Scenario.BALL_RADIUS if slot == 0 else PlayerBall.RADII[scene]
	var mesh := SphereMesh.new()
	mesh.radius = _radius
	mesh.height = _radius * 2.0
	var material := ShaderMaterial.new()
	material.shader = preload("ball.gdshader")
	material.set_shader_parameter("tint", Palette.get_player_color(slot))
	material.set_shader_parameter("radius", _radius)
	_ball.mesh = mesh
	_ball.material_override = material
	add_child(_ball)
	_label.text = player_name
	_label.billboard = BaseMaterial3D.BILLBOARD_ENABLED
	_label.no_depth_test = true
	_label.fixed_size = true
	_label.pixel_size = 0.0011
	_label.font_size = 24
	_label.outline_size = 9
	_label.modulate = Palette.get_player_color(slot).lightened(0.5)
	_label.outline_modulate = Color(0.04, 0.05, 0.08, 0.85)
	add_child(_label)


func show_pose(pose: Transform3D) -> void:
	_ball.transform = pose
	_label.position = pose.origin + Vector3(0.0, _radius + LABEL_GAP, 0.0)
