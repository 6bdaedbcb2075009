extends RefCounted
## Records the motion of bodies: writes the packets of a [MotorSender] with their times to a file.
##
## Format, little-endian: "GAMOTION", then per packet f32 seconds, u16 length, the bytes. A file
## loses no packets, so an internal receiver acknowledges each one at once.
##
## Until close(), the recording has the name of the file and ".part". After an error, such as a full
## disk, a file that was recorded before is unchanged.

const MAGIC := "GAMOTION"
const RECEIVER := 1
const SUFFIX := ".part"

var sender := MotorSender.new()
## Why nothing more is recorded; OK while all was written.
var error := OK

var _path: String
var _file: FileAccess
var _size := 0
var _reader := MotorReceiver.new()
var _time := 0.0


## Creates the file. [param bodies] are the poses at time 0.
func open(path: String, bodies: Dictionary[int, Transform3D]) -> Error:
	_path = path
	_file = FileAccess.open(path + SUFFIX, FileAccess.WRITE)
	if _file == null:
		error = FileAccess.get_open_error()
		return error
	_store(MAGIC.to_ascii_buffer())
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
		var header := PackedByteArray()
		header.resize(6)
		header.encode_float(0, time)
		header.encode_u16(4, bytes.size())
		_store(header + bytes)
		_reader.accept(bytes, time)
	_reader.advance(time)
	var ack := _reader.take_ack(time)
	if not ack.is_empty():
		sender.accept(RECEIVER, ack, time)


## Completes the file and returns its size in bytes; 0 if that fails, with the reason in `error`.
func close() -> int:
	if _file == null:
		return 0
	# The sender sends the last poses after its latency window.
	var end := _time + sender.max_latency
	while _time < end:
		record(_time + 1.0 / sender.ticks_per_second, {})
	_file.close()
	_file = null
	# Closing writes what is buffered, and reports no error.
	var written := FileAccess.open(_path + SUFFIX, FileAccess.READ)
	if error == OK and (written == null or written.get_length() != _size):
		error = ERR_FILE_CANT_WRITE
	if error == OK:
		error = DirAccess.rename_absolute(_path + SUFFIX, _path)
	if error != OK:
		DirAccess.remove_absolute(_path + SUFFIX)
	return _size if error == OK else 0


func _store(bytes: PackedByteArray) -> void:
	if error == OK and not _file.store_buffer(bytes):
		error = ERR_FILE_CANT_WRITE
	_size += bytes.size()
