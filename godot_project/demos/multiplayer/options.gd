extends RefCounted
## The options of the multiplayer demo, parsed from the arguments after `--`. [member problem]
## describes an invalid one.

const LineConditions := preload("res://demos/multiplayer/network/line_conditions.gd")
const Options := preload("res://demos/multiplayer/options.gd")

const DEFAULT_PORT := 24816
const ROLES: PackedStringArray = ["", "server", "client"]
const SCENES: PackedStringArray = ["cubes", "push"]
const CUBES: Dictionary[String, int] = {"cubes": 250, "push": 901}
const METHODS: PackedStringArray = ["motors", "synchronizer"]

## "server", "client", or empty to show the lobby.
var role := ""
## Address at which a client connects to the server.
var address := "127.0.0.1"
var port := DEFAULT_PORT
## "cubes" or "push". A client gets it from the server.
var scene := "cubes"
## Number of cubes, 0 for the default of the scene. A client gets it from the server.
var cubes := 0
## Initial replication method, "motors" or "synchronizer". A client can request the other.
var method := "motors"
## Duration of the scene in seconds, after which all processes quit; 0 for no end.
var seconds := 0.0
## Number of clients that the server waits for before the scene begins.
var clients := 0
## Whether there are a scripted ball and lifts. Without them the cubes fall and come to rest.
var life := true
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
## Name shown above the player's ball.
var player_name := "Player"
## Scripted player: "none", "circle" (drives in a circle), "kick" (kicks cube 0 every second) or
## "fiddle" (changes method, tolerance and mode in turn, one per second, and ends with the initial
## ones).
var autopilot := "none"
## File for a screenshot, and the seconds after which a client takes it and quits; empty for none.
var picture := ""
var picture_after := 6.0
## Describes the invalid argument, or empty.
var problem := ""


static func parse(arguments: PackedStringArray) -> Options:
	var options := Options.new()
	for argument: String in arguments:
		options._take(argument)
	if options.cubes == 0:
		options.cubes = CUBES[options.scene]
	return options


func _take(argument: String) -> void:
	var parts := argument.trim_prefix("--").split("=", true, 1)
	var value := parts[1] if parts.size() > 1 else ""
	match parts[0]:
		"demo":
			pass
		"role":
			role = _choice(argument, value, ROLES)
		"scene":
			scene = _choice(argument, value, SCENES)
		"method":
			method = _choice(argument, value, METHODS)
		"autopilot":
			autopilot = _choice(argument, value, ["none", "circle", "kick", "fiddle"])
		"life":
			life = _choice(argument, value, ["on", "off"]) == "on"
		"quit-when-empty":
			quit_when_empty = _choice(argument, value, ["on", "off"]) == "on"
		"address":
			address = value
		"name":
			player_name = value.left(24)
		"record":
			record = value
		"picture":
			picture = value
		"picture-after":
			picture_after = _number(argument, value, 0.0, 3600.0)
		"port":
			port = int(_number(argument, value, 1.0, 65535.0))
		"cubes":
			cubes = int(_number(argument, value, 1.0, 2000.0))
		"clients":
			clients = int(_number(argument, value, 0.0, 6.0))
		"seconds":
			seconds = _number(argument, value, 0.0, 86400.0)
		"calm":
			calm = _number(argument, value, 0.0, 3600.0)
		"leave-after":
			leave_after = _number(argument, value, 0.0, 3600.0)
		"seed":
			seed_value = int(_number(argument, value, 0.0, 2147483647.0))
		_:
			_take_condition(parts[0], argument, value)


func _take_condition(key: String, argument: String, value: String) -> void:
	match key:
		"loss":
			conditions.loss = _number(argument, value, 0.0, 100.0) / 100.0
		"burst":
			conditions.burst = _number(argument, value, 1.0, 100.0)
		"delay":
			conditions.delay = _number(argument, value, 0.0, 2000.0) / 1000.0
		"jitter":
			conditions.jitter = _number(argument, value, 0.0, 2000.0) / 1000.0
		"reorder":
			conditions.reorder = _number(argument, value, 0.0, 100.0) / 100.0
		"duplicate":
			conditions.duplicate = _number(argument, value, 0.0, 100.0) / 100.0
		"rate":
			conditions.rate = _number(argument, value, 0.0, 1e9)
		_:
			problem = "unknown argument %s; options.gd lists the valid ones" % argument


func _choice(argument: String, value: String, choices: PackedStringArray) -> String:
	if not choices.has(value):
		problem = "%s is invalid: use one of %s" % [argument, ", ".join(choices)]
		return choices[0]
	return value


func _number(argument: String, value: String, min_value: float, max_value: float) -> float:
	if not value.is_valid_float() or value.to_float() < min_value or value.to_float() > max_value:
		problem = "%s is invalid: use a number from %d to %d" % [argument, min_value, max_value]
		return min_value
	return value.to_float()
