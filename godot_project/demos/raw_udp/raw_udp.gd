extends Node3D
## Replication over a custom UDP socket: [MotorSender] and [MotorReceiver] do what
## [MotorSynchronizer] does, but leave the transport to the game. A server and a client run in one
## process and use the loopback interface. The orange cube shows the sent poses, the blue cube the
## received ones.

const StreamClient := preload("stream_client.gd")
const StreamServer := preload("stream_server.gd")

const BODY := 1
## The first client of the server.
const RECEIVER := 1
const ADDRESS := "127.0.0.1"

var server := StreamServer.new()
var client := StreamClient.new()
var sender := server.sender
var receiver := client.receiver

var _ticks := 0

@onready var _moved: Node3D = $Moved
@onready var _shown: Node3D = $Shown
@onready var _label: Label = $Label


func _ready() -> void:
	server.listen(ADDRESS)
	client.join(ADDRESS, server.get_port())
	sender.ticks_per_second = Engine.physics_ticks_per_second
	sender.add_body(BODY, _moved.transform)


## The sender, each tick: observe the pose, then process and send packets.
func _physics_process(_delta: float) -> void:
	_ticks += 1
	var time := float(_ticks) / Engine.physics_ticks_per_second
	_moved.transform = get_pose(time)
	sender.observe(BODY, time, _moved.transform)
	server.update(time, _now())


## The receiver, each frame: process and send packets, then show the pose.
func _process(_delta: float) -> void:
	client.update(_now())
	if receiver.has_body(BODY) and sender.has_receiver(RECEIVER):
		_shown.transform = receiver.get_transform(BODY)
		_shown.position.y -= 1.5
		var bytes: int = sender.get_statistics(RECEIVER).bytes_sent
		_label.text = (
			"Top: sent. Bottom: received. %.0f bytes/s"
			% (bytes * Engine.physics_ticks_per_second / float(_ticks))
		)


## The pose of the orange cube at a time in seconds.
func get_pose(time: float) -> Transform3D:
	var at := Vector3(2.0 * sin(time), 1.0 + 0.4 * sin(2.3 * time), 1.2 * cos(0.8 * time))
	return Transform3D(Basis.from_euler(Vector3(0.7 * time, 1.1 * time, 0.0)), at)


## A monotonic clock, in seconds.
func _now() -> float:
	return Time.get_ticks_usec() * 1e-6
