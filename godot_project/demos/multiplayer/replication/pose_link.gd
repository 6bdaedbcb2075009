@abstract
extends Node
## How poses get from the server to the clients: the border behind which methods are exchanged.
## The server calls the first part, a client the second. Bodies have numbers from 0; each is a node.

const PoseRecorder := preload("../measure/pose_recorder.gd")

## Where the link says it knows no time.
const NO_TICK := -1.0

## The bodies, at a client as they are shown.
var bodies: Array[Node3D] = []


## Both sides: begins, with that many bodies.
func open(body_count: int) -> void:
	for id: int in body_count:
		var body := Node3D.new()
		body.name = "B%d" % id
		add_child(body)
		bodies.append(body)


## Both sides: how far, in metres, what is shown may be from the truth, and the path between two samples
## (a [enum MultivectorLerp.Mode]). A method that knows neither takes no notice.
@abstract func tune(tolerance: float, mode: MultivectorLerp.Mode) -> void

## Server: a body appears.
@abstract func add_body(id: int, pose: Transform3D) -> void

## Server: a body is gone.
@abstract func remove_body(id: int) -> void

## Server: a client gets the poses by this method from now on.
@abstract func add_receiver(peer: int) -> void

## Server: a client gets them no longer, or has left.
@abstract func remove_receiver(peer: int) -> void


## Server: the poses of all bodies at a step of the physics engine.
func publish(poses: Dictionary[int, Transform3D]) -> void:
	for id: int in poses:
		bodies[id].transform = poses[id]


## Server: the tick that clients call the poses published last by, or [constant NO_TICK].
@abstract func get_sent_tick() -> float

## Client: gets poses by this method from now on. Of the bodies the first [param present_count] are never absent.
@abstract func begin(present_count: int) -> void

## Client: gets them no longer.
@abstract func end() -> void

## Client: true once there is something to show.
@abstract func is_ready() -> bool

## Client: the server's tick that is shown, or [constant NO_TICK].
@abstract func get_shown_tick() -> float

## Client: how far what is shown is behind the server beside what the network takes at least, in seconds.
@abstract func get_delay() -> float

## Both sides: counts for the report: late, rejected.
@abstract func get_counts() -> Dictionary[String, int]
