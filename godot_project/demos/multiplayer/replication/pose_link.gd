extends Node
## Interface of the replication methods, which send poses from the server to clients.
## Bodies are nodes with IDs from 0.

const PoseRecorder := preload("../measure/pose_recorder.gd")

## The tick of a method without a clock.
const NO_TICK := -1.0

## The bodies. On a client, they have the shown poses.
var bodies: Array[Node3D] = []


## Both sides: creates the bodies.
func open(body_count: int) -> void:
	for id: int in body_count:
		var body := Node3D.new()
		body.name = "B%d" % id
		add_child(body)
		bodies.append(body)


## Both sides: sets the tolerance in meters and the interpolation mode. A method without these
## ignores them.
func tune(_tolerance: float, _mode: MultivectorLerp.Mode) -> void:
	assert(false, "tune() is not overridden")


## Server: adds a body.
func add_body(_id: int, _pose: Transform3D) -> void:
	assert(false, "add_body() is not overridden")


## Server: removes a body.
func remove_body(_id: int) -> void:
	assert(false, "remove_body() is not overridden")


## Server: starts sending to a client.
func add_receiver(_peer: int) -> void:
	assert(false, "add_receiver() is not overridden")


## Server: stops sending to a client, which may have left.
func remove_receiver(_peer: int) -> void:
	assert(false, "remove_receiver() is not overridden")


## Server: publishes the poses of all bodies at a physics tick.
func publish(poses: Dictionary[int, Transform3D]) -> void:
	for id: int in poses:
		bodies[id].transform = poses[id]


## Server: the tick of the last published poses on the clock of the clients, or [constant NO_TICK].
func get_sent_tick() -> float:
	assert(false, "get_sent_tick() is not overridden")
	return 0.0


## Client: starts receiving. The first [param present_count] bodies always exist.
func begin(_present_count: int) -> void:
	assert(false, "begin() is not overridden")


## Client: stops receiving.
func end() -> void:
	assert(false, "end() is not overridden")


## Client: true once there are poses to show.
func is_ready() -> bool:
	assert(false, "is_ready() is not overridden")
	return false


## Client: the shown server tick, or [constant NO_TICK].
func get_shown_tick() -> float:
	assert(false, "get_shown_tick() is not overridden")
	return 0.0


## Client: the playback delay in seconds, in addition to the minimum network delay.
func get_delay() -> float:
	assert(false, "get_delay() is not overridden")
	return 0.0


## Both sides: the counts "late" and "rejected" for the report.
func get_counts() -> Dictionary[String, int]:
	assert(false, "get_counts() is not overridden")
	return {}
