extends Node3D
## The view of a client in the scene of avatars. H toggles the panels.

const Avatar := preload("avatar.gd")
const AvatarClient := preload("avatar_client.gd")
const AvatarHud := preload("avatar_hud.gd")
const CameraRig := preload("../view/camera_rig.gd")
const Layout := preload("../world/layout.gd")
const Options := preload("../options.gd")
const Palette := preload("../view/palette.gd")
const Screenshot := preload("../view/screenshot.gd")
const Stage := preload("../view/stage.gd")

const HEAD_SIZE := Vector3(0.2, 0.26, 0.22)
const VISOR_SIZE := Vector3(0.17, 0.09, 0.04)
const HAND_SIZE := Vector3(0.09, 0.05, 0.16)
const LABEL_HEIGHT := 0.35

var _options: Options
var _rig := CameraRig.new(Layout.AVATAR_HALF_EXTENT)
var _hud: AvatarHud
## True while the screenshot is taken; the statistics are then frozen.
var _is_taking_screenshot := false


func _init(client: AvatarClient, options: Options) -> void:
	_options = options
	add_child(Stage.new(Options.AVATARS, Layout.AVATAR_HALF_EXTENT))
	# Between the floor and the hands.
	_rig.height = 0.6
	_rig.distance *= 1.15
	add_child(_rig)
	_hud = AvatarHud.new(client)
	_hud.show_message("Connecting to %s:%d..." % [options.address, options.port])
	add_child(_hud)
	client.group.avatar_added.connect(_on_avatar_added)
	client.closed.connect(_on_closed)


func _ready() -> void:
	if not _options.screenshot.is_empty():
		get_viewport().disable_3d = true
		get_tree().create_timer(_options.screenshot_after).timeout.connect(_take_screenshot)


func _process(_delta: float) -> void:
	if not _is_taking_screenshot:
		_hud.update()
	_rig.free_area = _hud.get_free_area()


func _on_closed(reason: String) -> void:
	process_mode = Node.PROCESS_MODE_DISABLED
	_hud.show_message(reason)


func _on_avatar_added(slot: int, player_name: String, avatar: Avatar) -> void:
	var color := Palette.get_player_color(slot)
	_add_box(avatar.parts[0], HEAD_SIZE, color)
	var visor := _add_box(avatar.parts[0], VISOR_SIZE, Palette.SKY_TOP)
	visor.position = Vector3(0.0, 0.02, -HEAD_SIZE.z * 0.5)
	for hand: Node3D in avatar.parts.slice(1):
		_add_box(hand, HAND_SIZE, color)
	var label := Label3D.new()
	label.text = player_name
	label.billboard = BaseMaterial3D.BILLBOARD_ENABLED
	label.fixed_size = true
	label.pixel_size = 0.0011
	label.font_size = 20
	label.outline_size = 8
	label.modulate = color.lightened(0.5)
	label.position.y = LABEL_HEIGHT
	avatar.parts[0].add_child(label)


func _add_box(part: Node3D, size: Vector3, color: Color) -> MeshInstance3D:
	var mesh := BoxMesh.new()
	mesh.size = size
	var material := StandardMaterial3D.new()
	material.albedo_color = color
	material.roughness = 0.5
	mesh.material = material
	var instance := MeshInstance3D.new()
	instance.mesh = mesh
	part.add_child(instance)
	return instance


## 3D rendering is off until then, because software rendering would be too slow for realistic
## statistics.
func _take_screenshot() -> void:
	_is_taking_screenshot = true
	await Screenshot.save(get_viewport(), _options.screenshot)
	get_tree().quit()
