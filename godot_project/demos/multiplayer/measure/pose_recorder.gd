extends RefCounted
## Records poses to a file that tools/lib/pose_record.py reads.
##
## Little-endian: 8 bytes "GAPOSES1", u32 number of bodies; then per record f64 wall clock (seconds
## since 1970), f64 media time (ticks of the stream, fractional on a client; -1 if unknown), and per
## body 12 float32: rows of the 3x4 matrix, as in a MultiMesh.

const MAGIC := "GAPOSES1"

var _file: FileAccess
var _body_count: int


## Writes nothing if the path is empty.
func _init(path: String, body_count: int) -> void:
	_body_count = body_count
	if path.is_empty():
		return
	_file = FileAccess.open(path, FileAccess.WRITE)
	if _file == null:
		printerr(
			"Cannot write the recording %s: %s." % [path, error_string(FileAccess.get_open_error())]
		)
		return
	_file.store_buffer(MAGIC.to_ascii_buffer())
	_file.store_32(body_count)


func is_open() -> bool:
	return _file != null


func write(wall: float, tick: float, rows: PackedFloat32Array) -> void:
	if _file == null or rows.size() != _body_count * 12:
		return
	var times := PackedFloat64Array([wall, tick]).to_byte_array()
	if not _file.store_buffer(times + rows.to_byte_array()):
		printerr(
			(
				"Cannot write the recording %s further: %s. Check the free space on the disk."
				% [_file.get_path(), error_string(_file.get_error())]
			)
		)
		close()


func close() -> void:
	if _file != null:
		_file.close()
		_file = null


## Stores the pose of one body.
static func set_rows(rows: PackedFloat32Array, body: int, pose: Transform3D) -> void:
	var offset := body * 12
	for row: int in 3:
		rows[offset] = pose.basis.x[row]
		rows[offset + 1] = pose.basis.y[row]
		rows[offset + 2] = pose.basis.z[row]
		rows[offset + 3] = pose.origin[row]
		offset += 4
