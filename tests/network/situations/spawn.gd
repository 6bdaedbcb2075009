extends "base.gd"
## A MultiplayerSpawner adds bodies whose position only the server sets, before it adds them. With
## `spawn_synchronizer`, each has a MultiplayerSynchronizer that sends the position when it spawns.

const FIRST_AT := 1.5
const INTERVAL := 0.5
const COUNT := 4

var _spawner := MultiplayerSpawner.new()
var _spawned := 0


func _build() -> void:
	_spawner.name = &"Spawner"
	_spawner.spawn_function = _make
	world.add_child(_spawner)
	_spawner.spawn_path = ^".."


func _tick(_delta: float) -> void:
	if is_server and _spawned < COUNT and time > FIRST_AT + INTERVAL * _spawned:
		_spawner.spawn(_spawned)
		_spawned += 1


func _make(number_of_body: int) -> Node:
	var body := Node3D.new()
	body.name = "Body%d" % number_of_body
	prepare_body(body, "B%d" % number_of_body)
	if is_server:
		body.position = Vector3(3.0 + number_of_body, 0.0, 2.0 + number_of_body)
		body.position.y = 0.2 * sin(body.position.x)
	if flag("spawn_synchronizer"):
		var config_of_spawn := SceneReplicationConfig.new()
		config_of_spawn.add_property(^".:position")
		config_of_spawn.property_set_spawn(^".:position", true)
		config_of_spawn.property_set_replication_mode(
			^".:position", SceneReplicationConfig.REPLICATION_MODE_NEVER
		)
		var spawn_synchronizer := MultiplayerSynchronizer.new()
		spawn_synchronizer.name = &"SpawnSynchronizer"
		spawn_synchronizer.replication_config = config_of_spawn
		body.add_child(spawn_synchronizer)
	return body
