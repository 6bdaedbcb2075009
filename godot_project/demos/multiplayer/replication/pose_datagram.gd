extends RefCounted
## Poses of several ticks in datagrams of bounded size.
##
## Layout, little-endian: u8 version, u32 tick of sending, then groups of
## u8 age (ticks before the tick of sending), u16 length, and as many bytes of [MotorCodec].

const VERSION := 1
const HEADER := 5
const GROUP_HEADER := 3
## Larger ones would be split on the way, and losing a part loses all.
const MOST_BYTES := 1350
const MOST_AGE := 255


## The poses of one tick.
class Group:
	var tick := 0
	var ids := PackedInt32Array()
	var poses: Array[Transform3D] = []

	func add(id: int, pose: Transform3D) -> void:
		ids.append(id)
		poses.append(pose)


## A datagram taken apart; [member problem] is empty if all of it was sound.
class Content:
	var tick := 0
	var groups: Array[Group] = []
	var problem := ""


## As many datagrams as [param groups] need, each at most [constant MOST_BYTES] long.
static func pack(tick: int, groups: Array[Group], codec: MotorCodec) -> Array[PackedByteArray]:
	var datagrams: Array[PackedByteArray] = []
	var blobs: Array[PackedByteArray] = []
	for group: Group in groups:
		_encode(tick, group, codec, blobs)
	var current := PackedByteArray()
	for blob: PackedByteArray in blobs:
		if current.size() + blob.size() > MOST_BYTES and not current.is_empty():
			datagrams.append(current)
			current = PackedByteArray()
		if current.is_empty():
			current.resize(HEADER)
			current.encode_u8(0, VERSION)
			current.encode_u32(1, tick)
		current.append_array(blob)
	if not current.is_empty():
		datagrams.append(current)
	return datagrams


## Reads a datagram completely; on any fault only [member Content.problem] is of use.
static func unpack(bytes: PackedByteArray, codec: MotorCodec) -> Content:
	var content := Content.new()
	if bytes.size() < HEADER or bytes.decode_u8(0) != VERSION:
		content.problem = "not a datagram of version %d" % VERSION
		return content
	content.tick = bytes.decode_u32(1)
	var at := HEADER
	while at < bytes.size():
		if at + GROUP_HEADER > bytes.size():
			content.problem = "cut off in a group's header"
			return content
		var length := bytes.decode_u16(at + 1)
		var begin := at + GROUP_HEADER
		if begin + length > bytes.size():
			content.problem = "cut off in a group's poses"
			return content
		var decoded := codec.decode(bytes.slice(begin, begin + length))
		if decoded.has("error"):
			content.problem = str(decoded["error"])
			return content
		var group := Group.new()
		group.tick = content.tick - bytes.decode_u8(at)
		group.ids = decoded["ids"]
		group.poses.assign(decoded["transforms"] as Array)
		content.groups.append(group)
		at = begin + length
	return content


## Appends one blob (group header and poses) for [param group], or several where one would be too long.
static func _encode(tick: int, group: Group, codec: MotorCodec, blobs: Array[PackedByteArray]) -> void:
	var poses := codec.encode(group.ids, group.poses)
	if poses.size() + HEADER + GROUP_HEADER > MOST_BYTES and group.ids.size() > 1:
		var half := group.ids.size() >> 1
		for part: Vector2i in [Vector2i(0, half), Vector2i(half, group.ids.size())]:
			var piece := Group.new()
			piece.tick = group.tick
			piece.ids = group.ids.slice(part.x, part.y)
			piece.poses.assign(group.poses.slice(part.x, part.y))
			_encode(tick, piece, codec, blobs)
		return
	var blob := PackedByteArray()
	blob.resize(GROUP_HEADER)
	blob.encode_u8(0, clampi(tick - group.tick, 0, MOST_AGE))
	blob.encode_u16(1, poses.size())
	blob.append_array(poses)
	blobs.append(blob)
