extends "pose_link.gd"
## Replication with the built-in [MultiplayerSynchronizer]: one per body, which sends `transform` at
## 20 Hz. Received poses are shown at once, without interpolation.

const INTERVAL := 1.0 / 20.0

var _synchronizers: Array[MultiplayerSynchronizer] = []
var _present: Dictionary[int, bool] = {}
var _receivers: Array[int] = []
## On a client: bodies whose first pose has not arrived.
var _awaited: Dictionary[int, bool] = {}
var _is_receiving := false


func open(body_count: int) -> void:
	super(body_count)
	var configuration := SceneReplicationConfig.new()
	var property := NodePath(".:transform")
	configuration.add_property(property)
	configuration.property_set_replication_mode(
		property, SceneReplicationConfig.REPLICATION_MODE_ALWAYS
	)
	for id: int in body_count:
		var synchronizer := MultiplayerSynchronizer.new()
		synchronizer.name = "S"
		synchronizer.replication_config = configuration
		synchronizer.replication_interval = INTERVAL
		synchronizer.public_visibility = false
		synchronizer.visibility_update_mode = MultiplayerSynchronizer.VISIBILITY_PROCESS_NONE
		synchronizer.synchronized.connect(_on_synchronized.bind(id))
		bodies[id].add_child(synchronizer)
		_synchronizers.append(synchronizer)


func tune(_tolerance: float, _mode: MultivectorLerp.Mode) -> void:
	pass


func add_body(id: int, pose: Transform3D) -> void:
	bodies[id].transform = pose
	_present[id] = true
	_show_to(_receivers, id, true)


func remove_body(id: int) -> void:
	_present.erase(id)
	_show_to(_receivers, id, false)


func add_receiver(peer: int) -> void:
	_receivers.append(peer)
	for id: int in _present:
		_show_to([peer], id, true)


func remove_receiver(peer: int) -> void:
	_receivers.erase(peer)
	if multiplayer.get_peers().has(peer):
		for id: int in _present:
			_show_to([peer], id, false)


func publish(poses: Dictionary[int, Transform3D]) -> void:
	if not _receivers.is_empty():
		super(poses)


func get_sent_tick() -> float:
	return NO_TICK


func begin(present_count: int) -> void:
	_is_receiving = true
	for id: int in present_count:
		_awaited[id] = true


func end() -> void:
	_is_receiving = false


func is_ready() -> bool:
	return _is_receiving and _awaited.is_empty()


func get_shown_tick() -> float:
	return NO_TICK


func get_delay() -> float:
	return 0.0


func get_counts() -> Dictionary[String, int]:
	return {"late": 0, "rejected": 0}


func _on_synchronized(id: int) -> void:
	_awaited.erase(id)


func _show_to(peers: Array[int], id: int, value: bool) -> void:
	for peer: int in peers:
		_synchronizers[id].set_visibility_for(peer, value)
