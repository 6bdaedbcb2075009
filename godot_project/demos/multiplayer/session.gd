extends Node
## The messages between clients and server other than poses: players, input, settings, and the start
## and end of the scene. Each message emits a signal on the receiving side. The server validates the
## messages of clients.

## On a client: the server describes its scene, the number of cubes, the initial method and the run
## that it belongs to.
signal welcomed(scene: String, cubes: int, method: String, session: String)
## On a client: the server refuses the connection.
signal refused(reason: String)
## On a client: all players, each as [slot, peer, name].
signal roster_changed(roster: Array)
## On a client: the scene begins.
signal begun
## On a client: the scene ended at this tick on the clock of the links; negative if unknown.
signal finished(tick: float)
## On a client: the method that replicates poses from now on.
signal method_chosen(method: String)
## On a client: the tolerance in meters and the mode (a [enum MultivectorLerp.Mode]) from now on.
signal tuned(tolerance: float, mode: int)
## On a client: the ground truth of some bodies (truth.gd).
signal truth_received(bytes: PackedByteArray)
## On the server: a client is ready to receive poses.
signal entered(peer: int, player_name: String)
## On the server: the direction in which a player drives, of length 1 at most.
signal steered(peer: int, drive: Vector2, jump: bool)
## On the server: a client requests another method.
signal method_requested(peer: int, method: String)
## On the server: a client requests another tolerance and mode for all players.
signal tuning_requested(peer: int, tolerance: float, mode: int)
## On the server: a client requests or cancels ground truth.
signal truth_requested(peer: int, enabled: bool)
## On the server: a player kicks a cube.
signal kicked(peer: int, cube: int, direction: Vector3)

const MAX_NAME := 24
## Limits of the tolerance, in meters.
const MIN_TOLERANCE := 0.0005
const MAX_TOLERANCE := 0.1


## A name that no other player has: the requested one, or "Player" and the slot; with a number if it
## is taken.
static func get_unique_name(requested: String, slot: int, taken: Array[String]) -> String:
	var base := requested.strip_edges()
	if base.is_empty():
		base = "Player %d" % slot
	var unique := base
	var number := 1
	while taken.has(unique):
		number += 1
		unique = "%s (%d)" % [base, number]
	return unique


@rpc("authority", "call_remote", "reliable")
func welcome(scene: String, cubes: int, method: String, session: String) -> void:
	welcomed.emit(scene, cubes, method, session)


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
func send_truth(bytes: PackedByteArray) -> void:
	truth_received.emit(bytes)


@rpc("any_peer", "call_remote", "reliable")
func request_method(method: String) -> void:
	if multiplayer.is_server():
		method_requested.emit(multiplayer.get_remote_sender_id(), method)


@rpc("any_peer", "call_remote", "reliable")
func request_tuning(tolerance: float, mode: int) -> void:
	if (
		multiplayer.is_server()
		and is_finite(tolerance)
		and mode >= 0
		and mode <= MultivectorLerp.SEPARATE
	):
		var clamped := clampf(tolerance, MIN_TOLERANCE, MAX_TOLERANCE)
		tuning_requested.emit(multiplayer.get_remote_sender_id(), clamped, mode)


@rpc("any_peer", "call_remote", "reliable")
func request_truth(enabled: bool) -> void:
	if multiplayer.is_server():
		truth_requested.emit(multiplayer.get_remote_sender_id(), enabled)


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
