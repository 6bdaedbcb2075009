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
## At a client: the scene ended at this tick.
signal finished(tick: int)
## At the server: a client is ready to get poses.
signal entered(peer: int, player_name: String)
## At the server: where a player drives, at most 1 long.
signal steered(peer: int, drive: Vector2, jump: bool)
## At the server: a player kicks a cube.
signal kicked(peer: int, cube: int, direction: Vector3)

const LONGEST_NAME := 24


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


@rpc("authority", "call_remote", "reliable")
func finish(tick: int) -> void:
	finished.emit(tick)


@rpc("any_peer", "call_remote", "reliable")
func enter(player_name: String) -> void:
	if multiplayer.is_server():
		entered.emit(multiplayer.get_remote_sender_id(), player_name.left(LONGEST_NAME))


@rpc("any_peer", "call_remote", "unreliable_ordered", 2)
func steer(drive: Vector2, jump: bool) -> void:
	if multiplayer.is_server() and drive.is_finite():
		steered.emit(multiplayer.get_remote_sender_id(), drive.limit_length(1.0), jump)


@rpc("any_peer", "call_remote", "reliable")
func kick(cube: int, direction: Vector3) -> void:
	if multiplayer.is_server() and direction.is_finite() and direction.length_squared() > 0.01:
		kicked.emit(multiplayer.get_remote_sender_id(), cube, direction)
