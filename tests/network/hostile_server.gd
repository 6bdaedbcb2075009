extends SceneTree
## The server of the multiplayer demo. Counts the packets that arrive from clients, and how many of
## them it has rejected at that time.
##
## Takes the arguments of the demo after `--`.

const SCENE := "res://demos/multiplayer/multiplayer.tscn"

var _demo: Node
var _api: SceneMultiplayer
var _received := 0
var _last_received := 0
var _last_rejected := 0


func _initialize() -> void:
	var packed: PackedScene = load(SCENE)
	_demo = packed.instantiate()
	root.add_child(_demo)


func _process(_delta: float) -> bool:
	if _api == null:
		_api = _demo.multiplayer as SceneMultiplayer
		_api.peer_packet.connect(_on_peer_packet)
	for node: MotorSynchronizer in _demo.find_children("*", "MotorSynchronizer", true, false):
		var statistics := node.get_statistics()
		var rejected: int = statistics["rejected"]
		if rejected > _last_rejected:
			_last_received = _received
			_last_rejected = rejected
		break
	return false


func _finalize() -> void:
	print("Rejected %d of %d packets." % [_last_rejected, _last_received])


func _on_peer_packet(_peer: int, _packet: PackedByteArray) -> void:
	_received += 1
