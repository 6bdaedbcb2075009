extends RefCounted
## What the command line asks of the multiplayer demo: the arguments after `--`.
## An argument that is not understood leaves one line in [member problem].

const LineConditions := preload("res://demos/multiplayer/network/line_conditions.gd")
const Options := preload("res://demos/multiplayer/options.gd")

const DEFAULT_PORT := 24816
const ROLES: PackedStringArray = ["", "server", "client"]
const SCENES: PackedStringArray = ["cubes", "push"]
const CUBES: Dictionary[String, int] = {"cubes": 250, "push": 901}
const METHODS: PackedStringArray = ["motors", "synchronizer"]

## "server", "client", or empty: ask the user.
var role := ""
## The server's address, as a client uses it.
var address := "127.0.0.1"
var port := DEFAULT_PORT
## "cubes" or "push"; a client is told by the server.
var scene := "cubes"
## Number of cubes, 0 for the scene's own; a client is told by the server.
var cubes := 0
## "motors" or "synchronizer": how a client first gets its poses; it may ask for the other.
var method := "motors"
## Seconds of the scene to play, then everybody stops; 0 plays for ever.
var seconds := 0.0
## The server waits for this many clients before the scene begins.
var clients := 0
## False: no scripted ball, no lifts; the cubes only fall and come to rest.
var life := true
## So many seconds before its end the scene goes calm: nobody drives, no lift works, and all comes to rest.
var calm := 0.0
## A client leaves after so many seconds; 0: it stays.
var leave_after := 0.0
## True: the server ends when the last player has left.
var quit_when_empty := false
## File for the poses of every tick (server) or as shown (client); empty: none.
var record := ""
## How bad the network between a client and the server is made, in each direction.
var conditions := LineConditions.new()
## Seed of what the network does to each packet.
var seed_value := 1
## Name over the player's ball.
var player_name := "Player"
## A scripted player: "none", "circle" (drives round), "kick" (kicks cube 0 every second) or "fiddle" (changes method,
## bound and path in turn, one a second, and ends with what there was).
var autopilot := "none"
## Where a window saves a picture, and after how many seconds, before it closes.
var picture := ""
var picture_after := 6.0
## What is wrong with the arguments, or empty.
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
			problem = "unknown argument %s" % argument


func _choice(argument: String, value: String, choices: PackedStringArray) -> String:
	if not choices.has(value):
		problem = "%s: use one of %s" % [argument, ", ".join(choices)]
		return choices[0]
	return value


func _number(argument: String, value: String, least: float, most: float) -> float:
	if not value.is_valid_float() or value.to_float() < least or value.to_float() > most:
		problem = "%s: use a number from %d to %d" % [argument, least, most]
		return least
	return value.to_float()
