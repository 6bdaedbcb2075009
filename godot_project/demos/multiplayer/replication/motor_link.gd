extends "pose_link.gd"
## Replication by [MotorSynchronizer]: needs only the node on both sides and the bodies as its
## targets.

## Lever arm in meters at which the tolerances of position and rotation are equal.
const LEVER_ARM := 0.25
## Seconds; bytes count more here than the delay.
const MAX_LATENCY := 0.2

var _synchronizer := MotorSynchronizer.new()


func _init() -> void:
	_synchronizer.name = "Synchronizer"
	_synchronizer.max_latency = MAX_LATENCY


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE and is_instance_valid(_synchronizer):
		_synchronizer.free()


func tune(tolerance: float, mode: MultivectorLerp.Mode) -> void:
	_synchronizer.position_tolerance = tolerance
	_synchronizer.rotation_tolerance = rad_to_deg(tolerance / LEVER_ARM)
	_synchronizer.mode = mode


func add_body(id: int, pose: Transform3D) -> void:
	bodies[id].transform = pose
	_synchronizer.add_target(bodies[id])
	if not _synchronizer.is_inside_tree():
		add_child(_synchronizer)


func remove_body(id: int) -> void:
	_synchronizer.remove_target(bodies[id])


## The node subscribes to the poses on the client.
func add_receiver(_peer: int) -> void:
	pass


func remove_receiver(_peer: int) -> void:
	pass


## Returns the tick after the node's media time, because the node samples the bodies after this
## call.
func get_sent_tick() -> float:
	var seconds := _synchronizer.get_media_time(multiplayer.get_unique_id())
	return seconds * Engine.physics_ticks_per_second + 1.0 if seconds > 0.0 else NO_TICK


func begin(_present_count: int) -> void:
	for body: Node3D in bodies:
		_synchronizer.add_target(body)
	add_child(_synchronizer)


func end() -> void:
	remove_child(_synchronizer)


func is_ready() -> bool:
	return get_shown_tick() >= 0.0


func get_shown_tick() -> float:
	var seconds := _synchronizer.get_media_time(MultiplayerPeer.TARGET_PEER_SERVER)
	return seconds * Engine.physics_ticks_per_second if seconds > 0.0 else NO_TICK


func get_delay() -> float:
	return _synchronizer.get_statistics()["playback_delay"]


func get_counts() -> Dictionary[String, int]:
	var statistics := _synchronizer.get_statistics()
	return {
		"late": statistics["late"],
		"rejected": statistics["rejected"],
		"unauthorized": statistics["unauthorized"]
	}
