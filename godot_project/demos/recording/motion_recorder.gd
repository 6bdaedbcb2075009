extends RefCounted
## Records the motion of bodies: writes the packets of a [MotorSender] with their times to a file.
##
## Format, little-endian: "GAMOTION", then per packet f32 seconds, u16 length, the bytes. A file
## loses no packets, so an internal receiver acknowledges each one at once.

const MAGIC := "GAMOTION"
const RECEIVER := 1

var sender := MotorSender.new()

var _file: FileAccess
var _reader := MotorReceiver.new()
var _time := 0.0


## Creates the file. [param bodies] are the poses at time 0.
func open(path: String, bodies: Dictionary[int, Transform3D]) -> Error:
	_file = FileAccess.open(path, FileAccess.WRITE)
	if _file == null:
		return FileAccess.get_open_error()
	_file.store_buffer(MAGIC.to_ascii_buffer())
	for id: int in bodies:
		sender.add_body(id, bodies[id])
	sender.add_receiver(RECEIVER, 0.0)
	sender.max_latency = 0.2  # nobody waits for a file
	return OK


## Records the poses at a time in seconds. Call it each tick.
func record(time: float, bodies: Dictionary[int, Transform3D]) -> void:
	_time = time
	for id: int in bodies:
		sender.observe(id, time, bodies[id])
	for packet: Dictionary in sender.flush(time):
		var bytes: PackedByteArray = packet.bytes
		_file.store_float(time)
		_file.store_16(bytes.size())
		_file.store_buffer(bytes)
		_reader.accept(bytes, time)
	_reader.advance(time)
	var ack := _reader.take_ack(time)
	if not ack.is_empty():
		sender.accept(RECEIVER, ack, time)


## Closes the file and returns its size in bytes.
func close() -> int:
	# The sender sends the last poses after its latency window.
	var end := _time + sender.max_latency
	while _time < end:
		record(_time + 1.0 / sender.ticks_per_second, {})
	var size := _file.get_length()
	_file.close()
	_file = null
	return size
