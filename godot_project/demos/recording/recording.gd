extends Node3D
## Records four seconds of a swarm to a file, then plays it in a loop. The label shows the size of
## the file.

const MotionPlayer := preload("motion_player.gd")
const MotionRecorder := preload("motion_recorder.gd")

const PATH := "user://motion.gamotion"
const SECONDS := 4.0
const COUNT := 64

var _time := 0.0
var _player: MotionPlayer

@onready var _swarm: MultiMesh = ($Swarm as MultiMeshInstance3D).multimesh
@onready var _label: Label = $Label


func _ready() -> void:
	_swarm.instance_count = COUNT
	var recorder := MotionRecorder.new()
	var error := recorder.open(PATH, get_poses(0.0))
	if error != OK:
		_label.text = "Cannot write %s: %s." % [PATH, error_string(error)]
		set_process(false)
		return
	var rate := Engine.physics_ticks_per_second
	for tick in int(SECONDS * rate):
		recorder.record(float(tick) / rate, get_poses(float(tick) / rate))
	var size := recorder.close()
	if recorder.error != OK:
		_label.text = "Cannot write %s: %s." % [PATH, error_string(recorder.error)]
		set_process(false)
		return
	_label.text = (
		"%d cubes, %.0f s: %.1f kB, %.0f times smaller than float32 poses at %d Hz"
		% [COUNT, SECONDS, size / 1000.0, COUNT * SECONDS * rate * 28.0 / size, rate]
	)
	_rewind()


func _process(delta: float) -> void:
	_time += delta
	_player.play(_time)
	for id in COUNT:
		if _player.receiver.has_body(id):
			_swarm.set_instance_transform(id, _player.receiver.get_transform(id))
	if _player.is_over() and _player.receiver.get_media_time() > SECONDS - 0.5:
		_rewind()


func _rewind() -> void:
	_time = 0.0
	_player = MotionPlayer.new()
	_player.open(PATH)


## The poses of the swarm at a time in seconds.
static func get_poses(time: float) -> Dictionary[int, Transform3D]:
	var poses: Dictionary[int, Transform3D] = {}
	for id in COUNT:
		var angle := TAU * id / COUNT
		var radius := 2.0 + 0.5 * sin(3.0 * angle + time)
		var at := Vector3(
			radius * cos(angle + 0.6 * time),
			0.8 * sin(2.0 * angle + 1.7 * time),
			radius * sin(angle + 0.6 * time)
		)
		poses[id] = Transform3D(
			Basis(Vector3(cos(angle), 1.0, sin(angle)).normalized(), 1.3 * time + angle), at
		)
	return poses
