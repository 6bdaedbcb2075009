extends Node
## Records what a peer shows in each frame, and the bodies it owns in each physics tick, for
## situation_record.py: one JSON array per line.
##
## [kind, clock, media time, playback delay, {label: [x, y, z, is visible, is owned]}], with kind
## "f" for a frame and "t" for a tick, and ["e", clock, name] for an event. Times in seconds. Media
## time: of the server's stream, -1 if unknown.

const RECORDED := &"recorded"
## Node2D: pixels that count as a meter, and the radius, in meters, at which the rotation is
## recorded as the third coordinate.
const PIXELS_PER_METER := 100.0
const LEVER_ARM_2D := 0.2

var _file: FileAccess
var _synchronizer: MotorSynchronizer


func _init() -> void:
	# After the bodies have moved and the synchronizer has sampled or shown them.
	process_priority = 2000
	process_physics_priority = 2000


func open(path: String, synchronizer: MotorSynchronizer) -> void:
	_synchronizer = synchronizer
	_file = FileAccess.open(path, FileAccess.WRITE)


func _process(_delta: float) -> void:
	_write("f", false)


func _physics_process(_delta: float) -> void:
	if not get_tree().paused:
		_write("t", true)


func mark(event: String) -> void:
	_file.store_line(JSON.stringify(["e", _clock(), event], "", true, true))


func close() -> void:
	set_process(false)
	set_physics_process(false)
	_file.close()


func _write(kind: String, is_owned_only: bool) -> void:
	if _file == null:
		return
	var bodies := {}
	for node: Node in get_tree().get_nodes_in_group(RECORDED):
		var is_owned := node.is_multiplayer_authority()
		if is_owned or not is_owned_only:
			bodies[node.get_meta(&"label")] = _state(node, is_owned)
	if is_owned_only and bodies.is_empty():
		return
	var line := [kind, _clock(), _media_time(), _delay(), bodies]
	_file.store_line(JSON.stringify(line, "", true, true))


func _state(node: Node, is_owned: bool) -> Array:
	var item := node as Node2D
	if item != null:
		var at := item.global_position / PIXELS_PER_METER
		var turn := LEVER_ARM_2D * item.global_rotation
		return [at.x, at.y, turn, item.is_visible_in_tree(), is_owned]
	var body := node as Node3D
	var position := body.global_position
	return [position.x, position.y, position.z, body.is_visible_in_tree(), is_owned]


func _media_time() -> float:
	return _synchronizer.get_media_time(1) if _synchronizer.is_inside_tree() else -1.0


func _delay() -> float:
	if not _synchronizer.is_inside_tree():
		return 0.0
	var statistics := _synchronizer.get_statistics()
	return statistics["playback_delay"]


static func _clock() -> float:
	return Time.get_unix_time_from_system()
