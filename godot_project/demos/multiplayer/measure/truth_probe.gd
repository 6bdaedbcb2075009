extends RefCounted
## The server's part in showing clients how far off they are: four times a second it picks a few moving bodies by
## chance and notes where they are at the next ticks. It costs nothing while no client watches.

const Truth := preload("truth.gd")

## Ticks between two truths.
const PAUSE := 15
## A body that moved less than this since the tick before, in metres, is at rest: 1 mm/s.
const MIN_MOTION := 0.001 / 60.0

## Clients to tell.
var watchers: Array[int] = []

var _before: Dictionary[int, Transform3D] = {}
var _truth: Truth
var _ticks := 0
var _random := RandomNumberGenerator.new()


## Takes the poses of each tick, with what clients call it. A truth that is complete, or null.
func observe(tick: float, poses: Dictionary[int, Transform3D]) -> Truth:
	var complete: Truth = null
	_ticks += 1
	if watchers.is_empty():
		_truth = null
	elif _ticks % PAUSE == 0:
		_begin(tick, poses)
	if _truth != null and not _add_tick(poses):
		_truth = null
	if _truth != null and _truth.poses.size() == _truth.ids.size() * Truth.TICKS:
		complete = _truth
		_truth = null
	_before = poses
	return complete


func _begin(tick: float, poses: Dictionary[int, Transform3D]) -> void:
	_truth = Truth.new()
	_truth.tick = tick
	var ids := poses.keys()
	var start := _random.randi_range(0, ids.size())
	# A step that has no factor in common with most counts: neighbours move alike.
	for i: int in ids.size():
		var id: int = ids[(start + i * 37) % ids.size()]
		if _moved(id, poses) and not _truth.ids.has(id):
			_truth.ids.append(id)
			if _truth.ids.size() == Truth.MAX_BODIES:
				return
	if _truth.ids.is_empty():
		_truth = null


## False if a body is gone.
func _add_tick(poses: Dictionary[int, Transform3D]) -> bool:
	for id: int in _truth.ids:
		if not poses.has(id):
			return false
		_truth.poses.append(poses[id])
	return true


func _moved(id: int, poses: Dictionary[int, Transform3D]) -> bool:
	return _before.has(id) and _before[id].origin.distance_to(poses[id].origin) > MIN_MOTION
