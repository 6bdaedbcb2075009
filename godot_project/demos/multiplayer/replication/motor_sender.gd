extends RefCounted
## The server's side of the replication of poses as quantised motors: chooses which pose of
## which body is worth sending, and packs many into one datagram. It knows nothing of the network:
## what [method flush] returns goes to every receiver, what [method make_state] returns to a new one.

const BodyTrack := preload("body_track.gd")
const PoseDatagram := preload("pose_datagram.gd")

## Ticks between two datagrams; together with the span of a key it makes the playback delay.
const FLUSH_TICKS := 3
## Resting bodies whose pose is sent again with each datagram, in turn: mends what loss left behind.
const REFRESH_COUNT := 2

## The interpolated motion stays this close to the true one, in metres, before quantisation.
var tolerance := 0.005
## A body that stays this close to its pose, in metres, is at rest.
var rest_tolerance := 0.001
## The path between two samples.
var mode := MultivectorLerp.LINEAR
## Pose updates sent so far.
var sent_poses := 0
## Bodies that are not at rest.
var moving_count := 0

var _codec := MotorCodec.new()
var _tracks: Dictionary[int, BodyTrack] = {}
var _queue: Dictionary[int, PoseDatagram.Group] = {}
var _refresh_at := 0


func _init() -> void:
	_codec.position_tolerance = 0.001
	_codec.rotation_tolerance = 0.2


## Begins to send a body; its first pose goes out at once.
func add_body(id: int, tick: int, pose: Transform3D) -> void:
	var track := BodyTrack.new()
	track.start(tick, pose)
	_tracks[id] = track
	_enqueue(id, tick, pose)


## Begins anew from these poses, as all receivers know them.
func restart(tick: int, poses: Dictionary[int, Transform3D]) -> void:
	_queue.clear()
	for id: int in poses:
		_tracks[id].start(tick, poses[id])


func tune(p_tolerance: float, p_mode: MultivectorLerp.Mode) -> void:
	tolerance = p_tolerance
	mode = p_mode
	_codec.position_tolerance = tolerance * 0.2


func remove_body(id: int) -> void:
	_tracks.erase(id)


## Takes the true pose of a body at a tick; call it for every body at every tick.
func observe(id: int, tick: int, pose: Transform3D) -> void:
	var track := _tracks[id]
	if track.observe(tick, pose, tolerance, rest_tolerance, mode):
		_enqueue(id, track.key_tick, track.key_pose)
	elif track.take_repeat(tick):
		_enqueue(id, tick, track.key_pose)


## The datagrams due at this tick, if any.
func flush(tick: int) -> Array[PackedByteArray]:
	if tick % FLUSH_TICKS != 0:
		return []
	_refresh(tick)
	var groups: Array[PoseDatagram.Group] = []
	groups.assign(_queue.values())
	_queue.clear()
	for group: PoseDatagram.Group in groups:
		sent_poses += group.ids.size()
	return PoseDatagram.pack(tick, groups, _codec)


## Everything that a new receiver needs, to be sent reliably: all bodies' poses at this tick.
func make_state(tick: int, poses: Dictionary[int, Transform3D]) -> Array[PackedByteArray]:
	var group := PoseDatagram.Group.new()
	group.tick = tick
	for id: int in poses:
		group.add(id, poses[id])
	return PoseDatagram.pack(tick, [group], _codec)


func _enqueue(id: int, tick: int, pose: Transform3D) -> void:
	if not _queue.has(tick):
		var group := PoseDatagram.Group.new()
		group.tick = tick
		_queue[tick] = group
	_queue[tick].add(id, pose)


func _refresh(tick: int) -> void:
	var ids := _tracks.keys()
	var resting := 0
	var refreshed := 0
	for i: int in ids.size():
		var id: int = ids[(_refresh_at + i) % ids.size()]
		var track := _tracks[id]
		if not track.resting:
			continue
		resting += 1
		if refreshed < REFRESH_COUNT:
			refreshed += 1
			_enqueue(id, tick, track.key_pose)
			if refreshed == REFRESH_COUNT:
				_refresh_at = (_refresh_at + i + 1) % ids.size()
	moving_count = ids.size() - resting
