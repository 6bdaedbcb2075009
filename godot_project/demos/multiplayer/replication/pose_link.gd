@abstract
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
@abstract func tune(tolerance: float, mode: MultivectorLerp.Mode) -> void

## Server: adds a body.
@abstract func add_body(id: int, pose: Transform3D) -> void

## Server: removes a body.
@abstract func remove_body(id: int) -> void

## Server: starts sending to a client.
@abstract func add_receiver(peer: int) -> void

## Server: stops sending to a client, which may have left.
@abstract func remove_receiver(peer: int) -> void


## Server: publishes the poses of all bodies at a physics tick.
func publish(poses: Dictionary[int, Transform3D]) -> void:
	for id: int in poses:
		bodies[id].transform = poses[id]


## Server: the tick of the last published poses on the clock of the clients, or [constant NO_TICK].
@abstract func get_sent_tick() -> float

## Client: starts receiving. The first [param present_count] bodies always exist.
@abstract func begin(present_count: int) -> void

## Client: stops receiving.
@abstract func end() -> void

## Client: true once there are poses to show.
@abstract func is_ready() -> bool

## Client: the shown server tick, or [constant NO_TICK].
@abstract func get_shown_tick() -> float

## Client: the playback delay in seconds, in addition to the minimum network delay.
@abstract func get_delay() -> float

## Both sides: the counts "late" and "rejected" for the report.
@abstract func get_counts() -> Dictionary[String, int]
