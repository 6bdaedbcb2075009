extends RefCounted
## Writes the motion of bodies into a file: the packets that a [MotorReceiver] would get, each with the time it was made.
##
## Layout, little endian: "GAMOTION", then for each packet f32 seconds, u16 length, the bytes. A file loses nothing, so
## each packet is answered at once by a receiver of the recorder's own.

const MAGIC := "GAMOTION"
const RECEIVER := 1

var sender := MotorSender.new()

var _file: FileAccess
var _reader := MotorReceiver.new()
var _time := 0.0


## Begins a file. [param bodies]: the pose of each at time 0.
func open(path: String, bodies: Dictionary[int, Transform3D]) -> Error:
	_file = FileAccess.open(path, FileAccess.WRITE)
	if _file == null:
		return FileAccess.get_open_error()
	_file.store_buffer(MAGIC.to_ascii_buffer())
	for id: int in bodies:
		sender.add_body(id, bodies[id])
	sender.add_receiver(RECEIVER, 0.0)
	return OK


## Takes the poses of a time; call it in each tick.
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
	var answer := _reader.take_answer(time)
	if not answer.is_empty():
		sender.accept(RECEIVER, answer, time)


## Ends the file, and returns how many bytes it has.
func close() -> int:
	# The last poses leave the sender when its window is over.
	var end := _time + sender.max_latency
	while _time < end:
		record(_time + 1.0 / sender.ticks_per_second, {})
	var size := _file.get_length()
	_file.close()
	_file = null
	return size
