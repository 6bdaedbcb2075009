extends RefCounted
## What a receiver knows about one body: keys (server tick, pose) in order of
## time, and the segment of two keys that playback is in.
##
## The sender leaves out what interpolation between two keys reproduces, at most
## [constant SPAN] ticks long while the body moves, and everything of a body at rest. So a
## gap longer than [constant LONGEST_GAP] means rest: the body holds still and moves only in the
## last SPAN ticks before the later key. After the last key it holds still.

## Longest distance of two keys of a moving body, in ticks.
const SPAN := 6
## Longer gaps than this are rest, not lost keys.
const LONGEST_GAP := 18

## Set when [member from], [member to] or the ticks between them changed.
var changed := false
var from := Transform3D.IDENTITY
var to := Transform3D.IDENTITY

var _ticks := PackedInt32Array()
var _poses: Array[Transform3D] = []
var _start := 0.0
var _length := 0.0


func is_empty() -> bool:
	return _ticks.is_empty()


## Forgets everything: the body is gone, or another takes its place.
func clear() -> void:
	_ticks.clear()
	_poses.clear()
	_length = 0.0


## Takes a key in any order. False if it tells nothing new (a repeat, or older than what is shown).
func insert(tick: int, pose: Transform3D) -> bool:
	var at := _ticks.size()
	while at > 0 and _ticks[at - 1] > tick:
		at -= 1
	if at == 0 and not _ticks.is_empty():
		return false
	if at > 0 and _ticks[at - 1] == tick:
		return false
	_ticks.insert(at, tick)
	_poses.insert(at, pose)
	if at < 2:
		_take_segment()
	return true


## Moves on to the media time (in ticks, never less than before) and returns the weight
## between [member from] and [member to].
func advance(media: float) -> float:
	while _ticks.size() > 1 and float(_ticks[1]) <= media:
		_ticks.remove_at(0)
		_poses.remove_at(0)
		_take_segment()
	if _length <= 0.0:
		return 0.0
	return clampf((media - _start) / _length, 0.0, 1.0)


func _take_segment() -> void:
	changed = true
	from = _poses[0]
	if _ticks.size() == 1:
		to = from
		_length = 0.0
		return
	to = _poses[1]
	_start = float(_ticks[0])
	_length = float(_ticks[1]) - _start
	if _length > LONGEST_GAP:
		_start = float(_ticks[1] - SPAN)
		_length = SPAN
