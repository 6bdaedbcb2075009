extends RefCounted
## Ground truth: the poses of a few moving bodies at three consecutive ticks, which the server sends
## to clients that display their error.
##
## Encoding, little-endian: f64 first tick, u8 number of bodies; then for each body u16 ID and, for
## each tick, position and quaternion as 7 float32.

const Truth := preload("res://demos/multiplayer/measure/truth.gd")

const TICKS := 3
const MAX_BODIES := 8
const HEADER := 9
const POSE_BYTES := 28
const BODY_BYTES := 2 + TICKS * POSE_BYTES

## The first tick, on the clock of [code]PoseLink.get_shown_tick()[/code].
var tick := 0.0
var ids := PackedInt32Array()
## The poses of all bodies in the order of the IDs, for each tick.
var poses: Array[Transform3D] = []


func to_bytes() -> PackedByteArray:
	var bytes := PackedByteArray()
	bytes.resize(HEADER + ids.size() * BODY_BYTES)
	bytes.encode_double(0, tick)
	bytes.encode_u8(8, ids.size())
	for i: int in ids.size():
		bytes.encode_u16(HEADER + i * BODY_BYTES, ids[i])
		for step: int in TICKS:
			_encode(
				bytes, HEADER + i * BODY_BYTES + 2 + step * POSE_BYTES, poses[step * ids.size() + i]
			)
	return bytes


## Returns null if the bytes are malformed or an ID is not below [param body_count].
static func from_bytes(bytes: PackedByteArray, body_count: int) -> Truth:
	if bytes.size() < HEADER or bytes.size() != HEADER + bytes.decode_u8(8) * BODY_BYTES:
		return null
	var truth := Truth.new()
	truth.tick = bytes.decode_double(0)
	for i: int in bytes.decode_u8(8):
		truth.ids.append(bytes.decode_u16(HEADER + i * BODY_BYTES))
		if truth.ids[i] >= body_count:
			return null
	for step: int in TICKS:
		for i: int in truth.ids.size():
			truth.poses.append(_decode(bytes, HEADER + i * BODY_BYTES + 2 + step * POSE_BYTES))
	return truth


## Pose of the i-th body [param ticks] after the first tick, interpolated linearly.
func get_pose(i: int, ticks: float) -> Transform3D:
	var step := clampi(floori(ticks), 0, TICKS - 2)
	var from := poses[step * ids.size() + i]
	var to := poses[(step + 1) * ids.size() + i]
	return from.interpolate_with(to, clampf(ticks - step, 0.0, 1.0))


static func _encode(bytes: PackedByteArray, offset: int, pose: Transform3D) -> void:
	var rotation := pose.basis.get_rotation_quaternion()
	var numbers := PackedFloat32Array(
		[
			pose.origin.x,
			pose.origin.y,
			pose.origin.z,
			rotation.x,
			rotation.y,
			rotation.z,
			rotation.w
		]
	)
	for i: int in numbers.size():
		bytes.encode_float(offset + 4 * i, numbers[i])


static func _decode(bytes: PackedByteArray, offset: int) -> Transform3D:
	var numbers := bytes.slice(offset, offset + POSE_BYTES).to_float32_array()
	var origin := Vector3(numbers[0], numbers[1], numbers[2])
	var rotation := Quaternion(numbers[3], numbers[4], numbers[5], numbers[6])
	return Transform3D(
		(
			Basis(rotation.normalized())
			if rotation.is_finite() and rotation.length() > 0.5
			else Basis()
		),
		origin
	)
