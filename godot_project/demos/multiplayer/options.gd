extends RefCounted
## The options of the multiplayer demo, parsed from the arguments after `--`. [member error]
## describes an invalid argument.

const LineConditions := preload("res://demos/multiplayer/network/line_conditions.gd")
const Options := preload("res://demos/multiplayer/options.gd")

const DEFAULT_PORT := 24816
const ROLES: PackedStringArray = ["", "server", "client"]
## The scene in which each client owns an avatar. In the others the server simulates cubes.
const AVATARS := "avatars"
const SCENES: PackedStringArray = ["cubes", "push", AVATARS]
const CUBES: Dictionary[String, int] = {"cubes": 250, "push": 901, AVATARS: 0}
const MAX_CLIENTS: Dictionary[String, int] = {"cubes": 6, "push": 6, AVATARS: 16}
const METHODS: PackedStringArray = ["motors", "synchronizer"]

## "server", "client", or empty to show the lobby.
var role := ""
## Address at which a client connects to the server.
var address := "127.0.0.1"
var port := DEFAULT_PORT
## Identifies the run that this process belongs to: a client leaves a server of another one. Empty
## for a client that joins any server.
var session := ""
## "cubes", "push" or "avatars". A client gets it from the server.
var scene := "cubes"
## Number of cubes, 0 for the default of the scene. A client gets it from the server.
var cubes := 0
## Initial replication method, "motors" or "synchronizer". A client can request the other.
var method := "motors"
## Scene "avatars": whether MotorSynchronizer's "relay" forwards the motion of the clients, or
## Godot's SceneMultiplayer.server_relay. A client gets it from the server.
var relay := true
## Duration of the scene in seconds, after which all processes quit; 0 for no end.
var seconds := 0.0
## Number of clients that the server waits for before the scene begins.
var clients := 0
## Whether a scripted ball and lifts move the cubes. Without them the cubes fall and come to rest.
var scripted_motion := true
## Seconds before the end at which players, ball and lifts stop, so that all bodies come to rest.
var calm := 0.0
## Seconds after which a client leaves; 0 to stay.
var leave_after := 0.0
## Whether the server quits when the last player leaves.
var quit_when_empty := false
## File that records the poses of each tick (server) or of each frame (client); empty for none.
var record := ""
## Network impairments between a client and the server, in each direction.
var conditions := LineConditions.new()
## Seed of the network impairments.
var seed_value := 1
## Name shown above the player's ball. If empty, the server assigns "Player" and a number.
var player_name := ""
## Scripted player: "none", "circle" (drives in a circle), "kick" (kicks cube 0 every second) or
## "settings" (changes method, tolerance and mode in turn, one per second, and ends with the initial
## ones).
var autopilot := "none"
## File for a screenshot, and the seconds after which a client takes it and quits; empty for none.
var screenshot := ""
var screenshot_after := 6.0
## Describes the invalid argument; otherwise empty.
var error := ""


static func parse(arguments: PackedStringArray) -> Options:
	var options := Options.new()
	for argument: String in arguments:
		options._parse_argument(argument)
	if options.cubes == 0:
		options.cubes = CUBES[options.scene]
	if options.clients > MAX_CLIENTS[options.scene] and options.error.is_empty():
		options.error = (
			"--clients=%d is invalid: the scene %s has at most %d"
			% [options.clients, options.scene, MAX_CLIENTS[options.scene]]
		)
	return options


## "on" or "off".
func get_relay_name() -> String:
	return "on" if relay else "off"


func _parse_argument(argument: String) -> void:
	var parts := argument.trim_prefix("--").split("=", true, 1)
	var value := parts[1] if parts.size() > 1 else ""
	match parts[0]:
		"demo":
			pass
		"role":
			role = _parse_choice(argument, value, ROLES)
		"scene":
			scene = _parse_choice(argument, value, SCENES)
		"method":
			method = _parse_choice(argument, value, METHODS)
		"autopilot":
			autopilot = _parse_choice(argument, value, ["none", "circle", "kick", "settings"])
		"relay":
			relay = _parse_choice(argument, value, ["on", "off"]) == "on"
		"scripted-motion":
			scripted_motion = _parse_choice(argument, value, ["on", "off"]) == "on"
		"quit-when-empty":
			quit_when_empty = _parse_choice(argument, value, ["on", "off"]) == "on"
		"address":
			address = value
		"name":
			player_name = value.left(24)
		"session":
			session = value
		"record":
			record = value
		"screenshot":
			screenshot = value
		"screenshot-after":
			screenshot_after = _parse_number(argument, value, 0.0, 3600.0)
		"port":
			port = int(_parse_number(argument, value, 1.0, 65535.0))
		"cubes":
			cubes = int(_parse_number(argument, value, 1.0, 2000.0))
		"clients":
			clients = int(_parse_number(argument, value, 0.0, 16.0))
		"seconds":
			seconds = _parse_number(argument, value, 0.0, 86400.0)
		"calm":
			calm = _parse_number(argument, value, 0.0, 3600.0)
		"leave-after":
			leave_after = _parse_number(argument, value, 0.0, 3600.0)
		"seed":
			seed_value = int(_parse_number(argument, value, 0.0, 2147483647.0))
		_:
			_parse_condition(parts[0], argument, value)


func _parse_condition(key: String, argument: String, value: String) -> void:
	match key:
		"loss":
			conditions.loss = _parse_number(argument, value, 0.0, 100.0) / 100.0
		"burst":
			conditions.burst = _parse_number(argument, value, 1.0, 100.0)
		"delay":
			conditions.delay = _parse_number(argument, value, 0.0, 2000.0) / 1000.0
		"jitter":
			conditions.jitter = _parse_number(argument, value, 0.0, 2000.0) / 1000.0
		"reorder":
			conditions.reorder = _parse_number(argument, value, 0.0, 100.0) / 100.0
		"duplicate":
			conditions.duplicate = _parse_number(argument, value, 0.0, 100.0) / 100.0
		"rate":
			conditions.rate = _parse_number(argument, value, 0.0, 1e9)
		_:
			error = "unknown argument %s; options.gd lists the valid ones" % argument


func _parse_choice(argument: String, value: String, choices: PackedStringArray) -> String:
	if not choices.has(value):
		error = "%s is invalid: use one of %s" % [argument, ", ".join(choices)]
		return choices[0]
	return value


func _parse_number(argument: String, value: String, min_value: float, max_value: float) -> float:
	if not value.is_valid_float() or value.to_float() < min_value or value.to_float() > max_value:
		error = "%s is invalid: use a number from %d to %d" % [argument, min_value, max_value]
		return min_value
	return value.to_float()
