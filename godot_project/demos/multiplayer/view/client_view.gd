extends Node3D
## The view of a client: cubes in one MultiMesh, balls, stage and HUD. A click kicks a cube.

const BallView := preload("ball_view.gd")
const CameraRig := preload("camera_rig.gd")
const Client := preload("../client.gd")
const CubesView := preload("cubes_view.gd")
const Hud := preload("hud.gd")
const Layout := preload("../world/layout.gd")
const Options := preload("../options.gd")
const Screenshot := preload("screenshot.gd")
const Stage := preload("stage.gd")

## Maximum distance, in meters, from the mouse ray to the center of the cube that a click kicks.
const PICK_RADIUS := 0.42

var _client: Client
var _options: Options
var _scene := ""
var _multimesh: MultiMesh
var _rig: CameraRig
var _balls: Dictionary[int, BallView] = {}
var _shown_roster: Array = []
var _hud: Hud
## True while the screenshot is taken; the statistics are then frozen.
var _is_taking_screenshot := false


func _init(client: Client, options: Options) -> void:
	_client = client
	_options = options
	client.opened.connect(_on_opened)
	client.closed.connect(_on_closed)
	_hud = Hud.new(client)
	add_child(_hud)
	_hud.show_message("Connecting to %s:%d..." % [options.address, options.port])


func _process(_delta: float) -> void:
	if _multimesh == null:
		return
	if not _is_taking_screenshot:
		_hud.update()
	if not _client.link.is_ready():
		return
	for id: int in _client.link.bodies.size():
		_multimesh.set_instance_transform(id, _client.link.bodies[id].transform)
	_update_balls()
	_rig.target = _get_own_position()
	_rig.free_area = _hud.get_free_area()
	_client.get_input().yaw = _rig.yaw


func _unhandled_input(event: InputEvent) -> void:
	var button := event as InputEventMouseButton
	if (
		button == null
		or not button.pressed
		or button.button_index != MOUSE_BUTTON_LEFT
		or _multimesh == null
	):
		return
	var origin := _rig.camera.project_ray_origin(button.position)
	var direction := _rig.camera.project_ray_normal(button.position)
	var cube := _pick(origin, direction)
	if cube >= 0:
		_client.get_input().kick(cube, direction)


func _on_opened(scene: String, cubes: int) -> void:
	_scene = scene
	var layout := Layout.new(scene, cubes)
	var instance := CubesView.new(layout, _client.link.bodies.size())
	_multimesh = instance.multimesh
	add_child(instance)
	add_child(Stage.new(scene, layout.half_extent))
	_rig = CameraRig.new(layout.half_extent)
	add_child(_rig)
	_hud.open()
	if not _options.screenshot.is_empty():
		_prepare_screenshot()


func _on_closed(reason: String) -> void:
	process_mode = Node.PROCESS_MODE_DISABLED
	_hud.show_message(reason)


func _update_balls() -> void:
	if _shown_roster != _client.roster:
		_shown_roster = _client.roster
		_rebuild_balls()
	for slot: int in _balls:
		_balls[slot].show_pose(_client.link.bodies[_client.cube_count + slot].transform)


func _rebuild_balls() -> void:
	for slot: int in _balls:
		_balls[slot].queue_free()
	_balls.clear()
	for player: Array in _shown_roster:
		var slot: int = player[0]
		var player_name: String = player[2]
		var ball := BallView.new(_scene, slot, player_name)
		add_child(ball)
		_balls[slot] = ball
	_hud.show_players(_shown_roster, _client.get_own_slot())


func _get_own_position() -> Vector3:
	var slot := _client.get_own_slot()
	return (
		_client.link.bodies[_client.cube_count + slot].position
		if _balls.has(slot)
		else Vector3.ZERO
	)


## The nearest cube on a ray, or -1.
func _pick(origin: Vector3, direction: Vector3) -> int:
	var best := -1
	var best_along := INF
	for i: int in _client.cube_count:
		var offset := _client.link.bodies[i].position - origin
		var along := offset.dot(direction)
		if (
			along > 0.0
			and along < best_along
			and (offset - direction * along).length() < PICK_RADIUS
		):
			best = i
			best_along = along
	return best


## Runs the other method first, so that the screenshot shows the rates of both. 3D rendering is off
## until the screenshot, because software rendering would be too slow for realistic statistics.
func _prepare_screenshot() -> void:
	get_viewport().disable_3d = true
	var other := "synchronizer" if _client.method == "motors" else "motors"
	_client.request_method(other)
	var back := get_tree().create_timer(_options.screenshot_after * 0.5)
	back.timeout.connect(_client.request_method.bind(_client.method))
	get_tree().create_timer(_options.screenshot_after).timeout.connect(_take_screenshot)


func _take_screenshot() -> void:
	_is_taking_screenshot = true
	await Screenshot.save(get_viewport(), _options.screenshot)
	get_tree().quit()
