@abstract
extends Node
## How poses get from the server to the clients: the border behind which methods are exchanged.
## The server calls the first half, a client the second. Bodies have numbers from 0.

const PoseRecorder := preload("../measure/pose_recorder.gd")

## Pose updates that this client received, or that the server sent to each.
var pose_count := 0


## Server: begins, with numbers below [param body_count].
@abstract func open_sender(body_count: int) -> void


## Server: a body appears.
@abstract func add_body(id: int, tick: int, pose: Transform3D) -> void


## Server: a body is gone.
@abstract func remove_body(id: int) -> void


## Server: a client is ready; it gets the poses of all bodies now and their changes from now on.
@abstract func add_receiver(peer: int, tick: int, poses: Dictionary[int, Transform3D]) -> void


## Server: a client has left.
@abstract func remove_receiver(peer: int) -> void


## Server: the poses of all bodies after a step of the physics engine.
@abstract func publish(tick: int, poses: Dictionary[int, Transform3D]) -> void


## Client: begins, with numbers below [param body_count], of which the first [param present_count] are never absent.
## Called again, it forgets everything and begins anew.
@abstract func open_receiver(body_count: int, present_count: int) -> void


## Client: brings what is shown to [param local] seconds, and writes it down if a recorder is given.
@abstract func advance(local: float, recorder: PoseRecorder) -> void


## Client: how many bodies there are room for.
@abstract func get_body_count() -> int


## Client: the pose of a body as shown.
@abstract func get_pose(id: int) -> Transform3D


## Client: writes the poses of the first bodies as shown into a MultiMesh with one instance a body.
@abstract func show_in(multimesh: MultiMesh) -> void


## Client: a body has left.
@abstract func forget(id: int) -> void


## Client: true once there is something to show.
@abstract func is_ready() -> bool


## Client: how far what is shown is behind what arrives, in ms.
@abstract func get_delay_ms(local: float) -> float


## Client: the tick that is shown, or a very large number where the method knows no time.
@abstract func get_shown_tick() -> float


## Both sides: how far, in metres, what is shown may be from the truth, and the path between two samples
## (a [enum MultivectorLerp.Mode]). A method that knows neither takes no notice.
@abstract func tune(tolerance: float, mode: MultivectorLerp.Mode) -> void


## Client: further counts for the report: late, rejected.
@abstract func get_counts() -> Dictionary[String, int]
