extends Node3D
## A server and a client in one window, connected over ENet. The server (left) moves the cubes; the
## client (right) shows them. In a game, the two are separate programs with the same scene.

const FIRST_PORT := 24910
const PORTS := 20
const CUBES := 12
const BRANCHES: Array[String] = ["Server", "Client"]
## How long a path the error is measured against, in physics ticks.
const HISTORY_TICKS := 60

var _time := 0.0
## The positions of the server's cubes in the last ticks, the newest last.
var _history: Array[PackedVector3Array] = []

@onready var _server: Node3D = $Server
@onready var _client: Node3D = $Client
@onready var _label: Label = $Label


## Each branch gets a MultiplayerAPI of its own before its MotorSynchronizer enters the tree.
func _enter_tree() -> void:
	for branch in BRANCHES:
		get_tree().set_multiplayer(SceneMultiplayer.new(), _path_of(branch))


func _exit_tree() -> void:
	for branch in BRANCHES:
		get_tree().get_multiplayer(_path_of(branch)).multiplayer_peer.close()
		get_tree().set_multiplayer(null, _path_of(branch))


func _ready() -> void:
	# Peers identify a node by its path below the branch: both have the same names.
	for branch: Node3D in [_server, _client]:
		for i in CUBES:
			branch.add_child(_make_cube(i))
	var server := ENetMultiplayerPeer.new()
	for port in range(FIRST_PORT, FIRST_PORT + PORTS):
		if server.create_server(port) == OK:
			_server.multiplayer.multiplayer_peer = server
			var client := ENetMultiplayerPeer.new()
			client.create_client("127.0.0.1", port)
			_client.multiplayer.multiplayer_peer = client
			return
	_label.text = "No free port from %d to %d" % [FIRST_PORT, FIRST_PORT + PORTS - 1]
	set_physics_process(false)
	set_process(false)


func _physics_process(delta: float) -> void:
	_time += delta
	var positions := PackedVector3Array()
	for i in CUBES:
		var cube: Node3D = _server.get_node("Cube%d" % i)
		var angle := _time * (0.5 + 0.1 * i) + i
		cube.position = Vector3(2.0 * cos(angle), sin(2.0 * angle), 2.0 * sin(angle))
		cube.rotation = Vector3(0.0, -angle, 0.5 * angle)
		positions.append(cube.position)
	_history.append(positions)
	if _history.size() > HISTORY_TICKS:
		_history.pop_front()


func _process(_delta: float) -> void:
	var synchronizer: MotorSynchronizer = $Server/MotorSynchronizer
	_label.text = (
		"Server (left) to client (right): %.0f bytes/s for %d cubes, error at most %.1f mm"
		% [synchronizer.get_statistics()["sent_bytes_per_second"], CUBES, 1000.0 * get_error()]
	)


## The largest distance of a cube on the client from the path of that on the server, in meters. The
## client shows the motion 0.1 s later, so poses of the same moment cannot be compared.
func get_error() -> float:
	var error := 0.0
	for i in CUBES:
		var cube: Node3D = _client.get_node("Cube%d" % i)
		var nearest := INF
		for k in range(1, _history.size()):
			var point := Geometry3D.get_closest_point_to_segment(
				cube.position, _history[k - 1][i], _history[k][i]
			)
			nearest = minf(nearest, point.distance_to(cube.position))
		error = maxf(error, nearest)
	return error


func _path_of(branch: String) -> NodePath:
	return NodePath("%s/%s" % [get_path(), branch])


func _make_cube(index: int) -> MeshInstance3D:
	var cube := MeshInstance3D.new()
	cube.name = "Cube%d" % index
	var mesh := BoxMesh.new()
	mesh.size = 0.4 * Vector3.ONE
	var material := StandardMaterial3D.new()
	material.albedo_color = Color.from_hsv(index / float(CUBES), 0.6, 0.9)
	mesh.material = material
	cube.mesh = mesh
	cube.add_to_group(&"ga_godot_example")
	return cube
