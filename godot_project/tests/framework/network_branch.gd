extends RefCounted
## One of several peers in this process: a branch of the tree with its own MultiplayerAPI, a
## MotorSynchronizer and bodies. All branches have the same nodes, like real peers.

const LOCALHOST := "127.0.0.1"

var root := Node.new()
var api := SceneMultiplayer.new()
var world := Node3D.new()
var synchronizer := MotorSynchronizer.new()
## [peer, reason] of each packet_rejected signal.
var rejections: Array[Array] = []
## "+name" and "-name" for each target_added and target_removed signal.
var changes := PackedStringArray()

var _tree: SceneTree


## The synchronizer replicates the group "bodies" and enters the tree in [method start].
func _init(tree: SceneTree, branch_name: String) -> void:
	_tree = tree
	root.name = branch_name
	world.name = "World"
	synchronizer.name = "Motors"
	synchronizer.target_group = &"bodies"
	# Keeps the playback delay, and so the tests, short.
	synchronizer.max_latency = 0.1
	synchronizer.packet_rejected.connect(
		func(peer: int, reason: String) -> void: rejections.append([peer, reason])
	)
	synchronizer.target_added.connect(func(node: Node) -> void: changes.append("+%s" % node.name))
	synchronizer.target_removed.connect(func(node: Node) -> void: changes.append("-%s" % node.name))
	root.add_child(world)
	tree.root.add_child(root)
	tree.set_multiplayer(api, root.get_path())


## Adds bodies named "Body0", "Body1" and so on to the group "bodies".
func add_bodies(count: int, authority := 1) -> void:
	for i in count:
		add_body("Body%d" % i, authority)


func add_body(body_name: String, authority := 1) -> Node3D:
	var body := Node3D.new()
	body.name = body_name
	body.add_to_group(&"bodies")
	body.set_multiplayer_authority(authority)
	world.add_child(body)
	return body


func start() -> void:
	world.add_child(synchronizer)


func get_body(index: int) -> Node3D:
	return world.get_node("Body%d" % index)


## A port that the system chooses among the free ones, also those of other test runs.
static func find_free_port(websocket := false) -> int:
	if websocket:
		var server := TCPServer.new()
		server.listen(0)
		return server.get_local_port()
	var socket := PacketPeerUDP.new()
	socket.bind(0)
	return socket.get_local_port()


## Opens a server on a free port and returns the port.
func host(websocket := false) -> int:
	var port := find_free_port(websocket)
	var peer: MultiplayerPeer = (
		WebSocketMultiplayerPeer.new() if websocket else ENetMultiplayerPeer.new()
	)
	peer.call(&"create_server", port)
	api.multiplayer_peer = peer
	return port


func join(port: int, websocket := false) -> void:
	if websocket:
		var peer := WebSocketMultiplayerPeer.new()
		peer.create_client("ws://%s:%d" % [LOCALHOST, port])
		api.multiplayer_peer = peer
	else:
		var peer := ENetMultiplayerPeer.new()
		peer.create_client(LOCALHOST, port)
		api.multiplayer_peer = peer


func is_joined() -> bool:
	return (
		api.multiplayer_peer.get_connection_status() == MultiplayerPeer.CONNECTION_CONNECTED
		and not api.get_peers().is_empty()
	)


## Closes the connection without notice, like a process that crashes.
func leave() -> void:
	api.multiplayer_peer.close()
	api.multiplayer_peer = OfflineMultiplayerPeer.new()


func free_all() -> void:
	var path := root.get_path()
	leave()
	root.free()
	if not is_instance_valid(synchronizer):
		pass
	elif not synchronizer.is_inside_tree():
		synchronizer.free()
	_tree.set_multiplayer(null, path)
