extends RefCounted
## Plays a file of motion_recorder.gd: passes each packet to a receiver at its recorded time.

const MotionRecorder := preload("motion_recorder.gd")

## Bytes before each packet: its time and its length.
const HEADER_SIZE := 6

var receiver := MotorReceiver.new()

var _file: FileAccess
var _time := 0.0
var _packet := PackedByteArray()


func open(path: String) -> Error:
	_file = FileAccess.open(path, FileAccess.READ)
	if _file == null:
		return FileAccess.get_open_error()
	if (
		_file.get_buffer(MotionRecorder.MAGIC.length()).get_string_from_ascii()
		!= MotionRecorder.MAGIC
	):
		_file = null
		return ERR_FILE_UNRECOGNIZED
	_read_packet()
	return OK


## Advances to [param time] in seconds, which must not decrease.
func play(time: float) -> void:
	while not _packet.is_empty() and _time <= time:
		receiver.accept(_packet, _time)
		_read_packet()
	receiver.advance(time)


func is_over() -> bool:
	return _packet.is_empty()


func _read_packet() -> void:
	_packet = PackedByteArray()
	# The last packet of a file that was cut short is left out.
	var left := _file.get_length() - _file.get_position() - HEADER_SIZE
	if left < 0:
		return
	_time = _file.get_float()
	var size := _file.get_16()
	if size <= left:
		_packet = _file.get_buffer(size)
