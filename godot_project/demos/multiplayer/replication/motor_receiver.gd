extends RefCounted
## A client's side of the replication of poses as quantised motors: takes datagrams apart,
## keeps a timeline for each body, and shows all bodies at one media time through a [MotorPool].
## It knows nothing of the network: what arrives is given to [method accept].

const BodyTimeline := preload("body_timeline.gd")
const PlaybackClock := preload("playback_clock.gd")
const PoseDatagram := preload("pose_datagram.gd")

## The poses as shown, one a body, in the order of the ids.
var pool := MotorPool.new()
var clock := PlaybackClock.new()
## The path between two samples.
var mode := MultivectorLerp.LINEAR
var received_poses := 0
var received_datagrams := 0
## Datagrams that were not sound; nothing of them was applied.
var rejected_datagrams := 0
## Keys that came after their place in the motion had been shown.
var late_poses := 0
## Tick of the first whole state; before it there is nothing to show.
var first_tick := -1

var _codec := MotorCodec.new()
var _timelines: Array[BodyTimeline] = []
var _weights := PackedFloat32Array()
var _shown := -1.0


func _init(body_count: int) -> void:
	pool.reserve(body_count)
	_weights.resize(body_count)
	for i: int in body_count:
		_timelines.append(BodyTimeline.new())
		pool.acquire()


## Takes a datagram that arrived at [param local] seconds. False if it was not sound.
func accept(bytes: PackedByteArray, local: float) -> bool:
	var content := PoseDatagram.unpack(bytes, _codec)
	if not content.problem.is_empty() or not _are_known(content.groups):
		rejected_datagrams += 1
		return false
	received_datagrams += 1
	clock.observe(content.tick, local)
	if first_tick < 0:
		first_tick = content.tick
	for group: PoseDatagram.Group in content.groups:
		received_poses += group.ids.size()
		for i: int in group.ids.size():
			if float(group.tick) < _shown:
				late_poses += 1
			_timelines[group.ids[i]].insert(group.tick, group.poses[i])
	return true


## Forgets a body that has left.
func forget(id: int) -> void:
	_timelines[id].clear()


func has_body(id: int) -> bool:
	return not _timelines[id].is_empty()


## Brings [member pool] to the media time, in ticks; never less than before.
func show(media: float) -> void:
	_shown = media
	for id: int in _timelines.size():
		var timeline := _timelines[id]
		if timeline.is_empty():
			continue
		_weights[id] = timeline.advance(media)
		if timeline.changed:
			timeline.changed = false
			pool.set_from(id, timeline.from)
			pool.set_to(id, timeline.to)
	pool.interpolate_each(_weights, mode)


func _are_known(groups: Array[PoseDatagram.Group]) -> bool:
	for group: PoseDatagram.Group in groups:
		for id: int in group.ids:
			if id < 0 or id >= _timelines.size():
				return false
	return true
