extends Node3D
## Replication over a custom UDP socket: [MotorSender] and [MotorReceiver] do what
## [MotorSynchronizer] does, but leave the transport to the game. Both run in one process and use
## the loopback interface. The orange cube shows the sent poses, the blue cube the received ones.

const BODY := 1
const RECEIVER := 1
const ADDRESS := "127.0.0.1"

var sender := MotorSender.new()
var receiver := MotorReceiver.new()

var _out := PacketPeerUDP.new()
var _in := PacketPeerUDP.new()
var _ticks := 0

@onready var _moved: Node3D = $Moved
@onready var _shown: Node3D = $Shown
@onready var _label: Label = $Label


func _ready() -> void:
	_in.bind(0, ADDRESS)
	_out.connect_to_host(ADDRESS, _in.get_local_port())
	sender.ticks_per_second = Engine.physics_ticks_per_second
	sender.add_body(BODY, _moved.transform)
	sender.add_receiver(RECEIVER, 0.0)


## The sender, each tick: observe the pose, send the packets that are due, process acknowledgements.
func _physics_process(_delta: float) -> void:
	_ticks += 1
	var time := float(_ticks) / Engine.physics_ticks_per_second
	_moved.transform = get_pose(time)
	sender.observe(BODY, time, _moved.transform)
	for packet: Dictionary in sender.flush(time):
		var bytes: PackedByteArray = packet.bytes
		_out.put_packet(bytes)
	while _out.get_available_packet_count() > 0:
		sender.accept(RECEIVER, _out.get_packet(), time)


## The receiver, each frame: process packets, send an acknowledgement, show the pose.
func _process(_delta: float) -> void:
	var now := Time.get_ticks_usec() * 1e-6
	while _in.get_available_packet_count() > 0:
		var error := receiver.accept(_in.get_packet(), now)
		if not error.is_empty():
			push_warning("Rejected a packet: %s." % error)
		_in.set_dest_address(_in.get_packet_ip(), _in.get_packet_port())
	receiver.advance(now)
	var ack := receiver.take_ack(now)
	if not ack.is_empty():
		_in.put_packet(ack)
	if receiver.has_body(BODY):
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
