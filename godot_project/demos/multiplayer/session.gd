extends Node
## The talk between clients and server besides the poses: who plays, what they want, when the scene
## begins and ends. Each message becomes a signal at the other side; the server checks what it
## gets before it acts on it.

## At a client: the server tells which scene it plays, with how many cubes, by which method.
signal welcomed(scene: String, cubes: int, method: String)
## At a client: why the server does not let it in.
signal refused(reason: String)
## At a client: all players, as [slot, peer, name] each.
signal roster_changed(roster: Array)
## At a client: the scene begins.
signal begun
## At a client: the scene ended at this tick, as links tell it; negative if they do not.
signal finished(tick: float)
## At a client: by which method it gets the poses from now on.
signal method_chosen(method: String)
## At a client: the bound in metres and the path (a [enum MultivectorLerp.Mode]) that hold from now on.
signal tuned(tolerance: float, mode: int)
## At a client: where some bodies truly were (truth.gd).
signal truth_told(bytes: PackedByteArray)
## At the server: a client is ready to get poses.
signal entered(peer: int, player_name: String)
## At the server: where a player drives, at most 1 long.
signal steered(peer: int, drive: Vector2, jump: bool)
## At the server: a client wants its poses by another method.
signal method_wanted(peer: int, method: String)
## At the server: a client wants another bound and path, for everybody.
signal tuning_wanted(peer: int, tolerance: float, mode: int)
## At the server: a client wants to be told true poses, or no longer.
signal truth_wanted(peer: int, wanted: bool)
## At the server: a player kicks a cube.
signal kicked(peer: int, cube: int, direction: Vector3)

const MAX_NAME := 24
## Limits of the bound, in metres.
const MIN_TOLERANCE := 0.0005
const MAX_TOLERANCE := 0.1

@rpc("authority", "call_remote", "reliable")
func welcome(scene: String, cubes: int, method: String) -> void:
	welcomed.emit(scene, cubes, method)


@rpc("authority", "call_remote", "reliable")
func refuse(reason: String) -> void:
	refused.emit(reason)


@rpc("authority", "call_remote", "reliable")
func set_roster(roster: Array) -> void:
	roster_changed.emit(roster)


@rpc("authority", "call_remote", "reliable")
func begin() -> void:
	begun.emit()


@rpc("authority", "call_remote", "unreliable")
func finish(tick: float) -> void:
	finished.emit(tick)


@rpc("authority", "call_remote", "reliable")
func choose_method(method: String) -> void:
	method_chosen.emit(method)


@rpc("authority", "call_remote", "reliable")
func tune(tolerance: float, mode: int) -> void:
	tuned.emit(tolerance, mode)


@rpc("authority", "call_remote", "unreliable", 3)
func tell_truth(bytes: PackedByteArray) -> void:
	truth_told.emit(bytes)


@rpc("any_peer", "call_remote", "reliable")
func want_method(method: String) -> void:
	if multiplayer.is_server():
		method_wanted.emit(multiplayer.get_remote_sender_id(), method)


@rpc("any_peer", "call_remote", "reliable")
func want_tuning(tolerance: float, mode: int) -> void:
	if (
		multiplayer.is_server()
		and is_finite(tolerance)
		and mode >= 0
		and mode <= MultivectorLerp.SEPARATE
	):
		var bound := clampf(tolerance, MIN_TOLERANCE, MAX_TOLERANCE)
		tuning_wanted.emit(multiplayer.get_remote_sender_id(), bound, mode)


@rpc("any_peer", "call_remote", "reliable")
func want_truth(wanted: bool) -> void:
	if multiplayer.is_server():
		truth_wanted.emit(multiplayer.get_remote_sender_id(), wanted)


@rpc("any_peer", "call_remote", "reliable")
func enter(player_name: String) -> void:
	if multiplayer.is_server():
		entered.emit(multiplayer.get_remote_sender_id(), player_name.left(MAX_NAME))


@rpc("any_peer", "call_remote", "unreliable_ordered", 2)
func steer(drive: Vector2, jump: bool) -> void:
	if multiplayer.is_server() and drive.is_finite():
		steered.emit(multiplayer.get_remote_sender_id(), drive.limit_length(1.0), jump)


@rpc("any_peer", "call_remote", "reliable")
func kick(cube: int, direction: Vector3) -> void:
	if multiplayer.is_server() and direction.is_finite() and direction.length_squared() > 0.01:
		kicked.emit(multiplayer.get_remote_sender_id(), cube, direction)
