extends RefCounted
## Collects ground truth on the server: four times a second it samples a few moving bodies at random
## and stores their poses at consecutive ticks. It costs nothing while no client requests it.

const Truth := preload("truth.gd")

## Ticks between two samples.
const INTERVAL := 15
## Meters per tick below which a body is at rest: 1 mm/s.
const MIN_MOTION := 0.001 / 60.0

## Peers that request ground truth.
var watchers: Array[int] = []

var _before: Dictionary[int, Transform3D] = {}
var _truth: Truth
var _ticks := 0
var _random := RandomNumberGenerator.new()


## Processes the poses of a tick. [param tick] is on the clock of the clients. Returns a complete
## ground truth or null.
func observe(tick: float, poses: Dictionary[int, Transform3D]) -> Truth:
	var complete: Truth = null
	_ticks += 1
	if watchers.is_empty():
		_truth = null
	elif _ticks % INTERVAL == 0:
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
	# Neighboring bodies move similarly, so take every 37th body. This visits all bodies unless
	# their number is a multiple of 37.
	for i: int in ids.size():
		var id: int = ids[(start + i * 37) % ids.size()]
		if _moved(id, poses) and not _truth.ids.has(id):
			_truth.ids.append(id)
			if _truth.ids.size() == Truth.MAX_BODIES:
				return
	if _truth.ids.is_empty():
		_truth = null


## Returns false if a body was removed.
func _add_tick(poses: Dictionary[int, Transform3D]) -> bool:
	for id: int in _truth.ids:
		if not poses.has(id):
			return false
		_truth.poses.append(poses[id])
	return true


func _moved(id: int, poses: Dictionary[int, Transform3D]) -> bool:
	return _before.has(id) and _before[id].origin.distance_to(poses[id].origin) > MIN_MOTION
