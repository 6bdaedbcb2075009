extends "pose_link.gd"
## Poses as Godot does it: one MultiplayerSynchronizer a body that sends `transform` at 20 Hz. What
## arrives is shown at once, as it is.

const INTERVAL := 1.0 / 20.0

var _bodies: Array[Node3D] = []
var _synchronizers: Array[MultiplayerSynchronizer] = []
var _present: Dictionary[int, bool] = {}
var _receivers: Array[int] = []
## At a client: bodies of which nothing has arrived yet.
var _awaited: Dictionary[int, bool] = {}
var _rows := PackedFloat32Array()


func open_sender(body_count: int) -> void:
	_add_nodes(body_count)


func add_body(id: int, _tick: int, pose: Transform3D) -> void:
	_bodies[id].transform = pose
	_present[id] = true
	for peer: int in _receivers:
		_synchronizers[id].set_visibility_for(peer, true)


func remove_body(id: int) -> void:
	_present.erase(id)
	for peer: int in _receivers:
		_synchronizers[id].set_visibility_for(peer, false)


func add_receiver(peer: int, _tick: int, poses: Dictionary[int, Transform3D]) -> void:
	_receivers.append(peer)
	for id: int in poses:
		_bodies[id].transform = poses[id]
		_synchronizers[id].set_visibility_for(peer, true)


func remove_receiver(peer: int) -> void:
	_receivers.erase(peer)
	if not multiplayer.get_peers().has(peer):
		return
	for id: int in _present:
		_synchronizers[id].set_visibility_for(peer, false)


func publish(_tick: int, poses: Dictionary[int, Transform3D]) -> void:
	if _receivers.is_empty():
		return
	for id: int in poses:
		_bodies[id].transform = poses[id]


func open_receiver(body_count: int, present_count: int) -> void:
	for id: int in present_count:
		_awaited[id] = true
	if not _bodies.is_empty():
		return
	_add_nodes(body_count)
	_rows.resize(body_count * 12)
	for id: int in body_count:
		_synchronizers[id].synchronized.connect(_on_synchronized.bind(id))


func advance(_local: float, recorder: PoseRecorder) -> void:
	if not recorder.is_open() or not is_ready():
		return
	var wall := Time.get_unix_time_from_system()
	for id: int in _bodies.size():
		PoseRecorder.set_rows(_rows, id, _bodies[id].transform)
	recorder.write(wall, PoseRecorder.NO_TICK, _rows)


func get_body_count() -> int:
	return _bodies.size()


func get_pose(id: int) -> Transform3D:
	return _bodies[id].transform


func show_in(multimesh: MultiMesh) -> void:
	for id: int in _bodies.size():
		multimesh.set_instance_transform(id, _bodies[id].transform)


func forget(_id: int) -> void:
	pass


func is_ready() -> bool:
	return pose_count > 0 and _awaited.is_empty()


func get_delay_ms(_local: float) -> float:
	return 0.0


func get_shown_tick() -> float:
	return INF


func tune(_tolerance: float, _mode: MultivectorLerp.Mode) -> void:
	pass


func get_counts() -> Dictionary[String, int]:
	return {"late": 0, "rejected": 0}


func _on_synchronized(id: int) -> void:
	pose_count += 1
	_awaited.erase(id)


func _add_nodes(count: int) -> void:
	var configuration := SceneReplicationConfig.new()
	var property := NodePath(".:transform")
	configuration.add_property(property)
	configuration.property_set_replication_mode(property, SceneReplicationConfig.REPLICATION_MODE_ALWAYS)
	for id: int in count:
		var body := Node3D.new()
		body.name = "B%d" % id
		var synchronizer := MultiplayerSynchronizer.new()
		synchronizer.name = "S"
		synchronizer.replication_config = configuration
		synchronizer.replication_interval = INTERVAL
		synchronizer.public_visibility = false
		synchronizer.visibility_update_mode = MultiplayerSynchronizer.VISIBILITY_PROCESS_NONE
		body.add_child(synchronizer)
		add_child(body)
		_bodies.append(body)
		_synchronizers.append(synchronizer)
