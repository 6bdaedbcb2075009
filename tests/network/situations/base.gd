extends Node
## One process of a situation, server or client: connects, builds the same world on every peer,
## begins on all peers at the same time, moves what the peer owns, records what it shows.
##
## A situation extends this script and overrides the functions of "To override". The world is below
## `world`, which pauses with the tree; this node does not.

const Recorder := preload("recorder.gd")

const MOVING := &"moving"
## Seconds for start and end, after which a process gives up.
const SPARE := 50.0
## Speed of the bodies along x, in m/s.
const SPEED := 2.0

var arguments: Dictionary[String, String] = {}
var config: Dictionary = {}
var is_server := false
## 0 for the server, 1 and up for the clients.
var index := 0
var world: Node3D
var synchronizer: MotorSynchronizer
## Ids of the peers by their index.
var ids: Dictionary[int, int] = {0: 1}
var recorder: Recorder
## Seconds since the situation began; negative before.
var time := -1.0

var _enet: ENetMultiplayerPeer
var _began := -1.0
var _counted_from := -1.0
var _is_ready := false


func _ready() -> void:
	process_mode = Node.PROCESS_MODE_ALWAYS
	is_server = arguments["role"] == "server"
	index = int(arguments["index"])
	config = JSON.parse_string(arguments["config"])
	Engine.physics_ticks_per_second = int(number("ticks", 60.0))
	Engine.max_fps = int(number("server_fps" if is_server else "client_fps", 120.0))
	_connect_peer()
	world = Node3D.new()
	world.name = &"World"
	world.process_mode = Node.PROCESS_MODE_PAUSABLE
	add_child(world)
	synchronizer = new_synchronizer()
	synchronizer.target_group = &"targets"
	_build()
	if synchronizer.get_parent() == null:
		world.add_child(synchronizer)
	recorder = Recorder.new()
	recorder.open(arguments["record"], synchronizer)
	add_child(recorder)


func _physics_process(delta: float) -> void:
	if _began < 0.0:
		return
	time = now() - _began
	if get_tree().paused:
		return
	if not flag("moves_in_frames"):
		_move_all(delta)
	_tick(delta)


func _process(delta: float) -> void:
	if is_server and not _is_ready and ids.size() > int(number("clients")):
		_is_ready = true
		print("READY")
	if is_server and _is_ready and _began < 0.0 and FileAccess.file_exists(arguments["go"]):
		_begin_everywhere.rpc(ids)
	if _began >= 0.0:
		time = now() - _began
		if flag("moves_in_frames") and not get_tree().paused:
			_move_all(delta)
		_frame(delta)
	if _counted_from < 0.0 and time > number("count_from"):
		_counted_from = time
		_enet.host.pop_statistic(ENetConnection.HOST_TOTAL_SENT_DATA)
		_enet.host.pop_statistic(ENetConnection.HOST_TOTAL_SENT_PACKETS)
	if is_server and time > number("seconds"):
		_end_everywhere.rpc()
	if Time.get_ticks_msec() > (number("seconds") + SPARE) * 1000.0:
		printerr("ERROR: the situation did not end.")
		get_tree().quit(3)


# --- To override.


## Adds the nodes that exist from the start, on every peer.
func _build() -> void:
	pass


## The situation begins, on every peer.
func _begin() -> void:
	pass


func _tick(_delta: float) -> void:
	pass


func _frame(_delta: float) -> void:
	pass


## Moves a body that this peer owns.
func _move(body: Node, delta: float) -> void:
	var item := body as Node2D
	if item != null:
		item.position.x += speed_of(body) * delta
		item.position.y = 20.0 * sin(0.01 * item.position.x)
		item.rotation = 0.3 * sin(0.01 * item.position.x)
		item.scale = Vector2.ONE * (1.0 + 0.2 * sin(0.01 * item.position.x))
		return
	var node := body as Node3D
	var x := node.position.x + speed_of(body) * delta
	# At once: an AnimatableBody3D keeps only one change in a tick.
	var turn := Basis(Vector3.UP, 0.3 * sin(x))
	node.transform = Transform3D(turn, Vector3(x, 0.2 * sin(x), node.position.z))


## Wraps the transport.
func _wrap(peer: ENetMultiplayerPeer) -> MultiplayerPeer:
	return peer


# --- For situations.


func number(key: String, default: float = 0.0) -> float:
	return config.get(key, default)


func text(key: String) -> String:
	return config.get(key, "")


func flag(key: String, default: bool = false) -> bool:
	return config.get(key, default)


## The monotonic clock of this process, in seconds.
func now() -> float:
	return Time.get_ticks_usec() * 1e-6


func new_synchronizer() -> MotorSynchronizer:
	var node := MotorSynchronizer.new()
	node.name = &"MotorSynchronizer"
	var properties: Dictionary = config.get("properties", {})
	for key: String in properties:
		if key in node:
			node.set(key, properties[key])
		else:
			print("MISSING ", key)
	return node


## Adds a target. A body with a speed is moved by its authority.
func add_body(body: Node, label: String, parent: Node, speed: float = SPEED) -> void:
	body.name = label
	prepare_body(body, label, speed)
	parent.add_child(body)


func prepare_body(body: Node, label: String, speed: float = SPEED) -> void:
	body.set_meta(&"label", label)
	body.set_meta(&"speed", speed)
	body.add_to_group(&"targets")
	body.add_to_group(Recorder.RECORDED)
	if speed != 0.0:
		body.add_to_group(MOVING)


func speed_of(body: Node) -> float:
	return body.get_meta(&"speed", 0.0)


@rpc("authority", "call_local", "reliable")
func _end_everywhere() -> void:
	set_process(false)
	set_physics_process(false)
	recorder.close()
	var report := {
		# What the transport has sent since `count_from`, with ENet's overhead.
		"seconds": time - _counted_from,
		"bytes": _enet.host.pop_statistic(ENetConnection.HOST_TOTAL_SENT_DATA),
		"datagrams": _enet.host.pop_statistic(ENetConnection.HOST_TOTAL_SENT_PACKETS),
		"warnings": Array(synchronizer.get_setup_warnings()),
	}
	_report(report)
	print("REPORT ", JSON.stringify(report))
	if is_server:
		# The clients leave when the message has arrived.
		var end := now() + 2.0
		while not multiplayer.get_peers().is_empty() and now() < end:
			await get_tree().process_frame
	else:
		multiplayer.server_disconnected.disconnect(_on_disconnected)
		# One after the other: the server tells the others of each client that leaves.
		await get_tree().create_timer(0.1 * index).timeout
	multiplayer.multiplayer_peer.close()
	get_tree().quit()


## Adds to the report of this process.
func _report(_report_of_process: Dictionary) -> void:
	pass


# --- Connection.


func _connect_peer() -> void:
	_enet = ENetMultiplayerPeer.new()
	var error := (
		_enet.create_server(int(arguments["port"]))
		if is_server
		else _enet.create_client("127.0.0.1", int(arguments["port"]))
	)
	if error != OK:
		printerr("ERROR: cannot use port %s: %s." % [arguments["port"], error_string(error)])
		get_tree().quit(2)
		return
	var api := multiplayer as SceneMultiplayer
	api.server_relay = flag("server_relay", true)
	api.multiplayer_peer = _wrap(_enet)
	if not is_server:
		api.connected_to_server.connect(_on_connected)
		api.server_disconnected.connect(_on_disconnected)


func _on_disconnected() -> void:
	printerr("ERROR: the connection to the server was lost.")
	get_tree().quit(3)


func _on_connected() -> void:
	_introduce.rpc_id(1, index)


@rpc("any_peer", "reliable")
func _introduce(peer_index: int) -> void:
	ids[peer_index] = multiplayer.get_remote_sender_id()


@rpc("authority", "call_local", "reliable")
func _begin_everywhere(all_ids: Dictionary) -> void:
	ids.assign(all_ids)
	_began = now()
	time = 0.0
	recorder.mark("begin")
	_begin()


func _move_all(delta: float) -> void:
	for body: Node in get_tree().get_nodes_in_group(MOVING):
		if body.is_multiplayer_authority():
			_move(body, delta)
