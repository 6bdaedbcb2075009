extends RefCounted
## The pose error on a client: the distance between the shown poses of some moving bodies and the
## poses that the server had at the same media time. It is the largest distance among the center and
## three points 0.25 m along the axes.
##
## For a method with a clock, the poses of the shown tick are compared. For one without, the shown
## pose is compared with each tick of the ground truth when that arrives, and the tick with the
## smallest mean error counts. Thus neither the network delay nor the method's mean delay counts as
## an error, as in the table of tools/demo.

const PoseLink := preload("../replication/pose_link.gd")
const Truth := preload("truth.gd")

## Lever arm of rotation errors, in meters.
const LEVER_ARM := 0.25
## Maximum number of ground truths that wait for their tick to be shown.
const MAX_WAITING := 16
## Number of errors that the statistics cover: about two seconds.
const WINDOW := 64
## Weight of the past in the running mean that chooses the tick for a method without a clock.
const PAST_WEIGHT := 0.95

var _waiting: Array[Truth] = []
var _errors := PackedFloat32Array()
var _means := PackedFloat32Array([0.0, 0.0, 0.0])


## Discards all errors. Call it when the method changes.
func clear() -> void:
	_waiting.clear()
	_errors.clear()
	_means.fill(0.0)


## Processes a ground truth that has arrived.
func take(truth: Truth, link: PoseLink) -> void:
	if not link.is_ready():
		return
	if link.get_shown_tick() >= 0.0:
		_waiting.append(truth)
		if _waiting.size() > MAX_WAITING:
			_waiting.remove_at(0)
	else:
		_compare_untimed(truth, link)


## Call it after each frame.
func update(link: PoseLink) -> void:
	var shown := link.get_shown_tick()
	for index: int in range(_waiting.size() - 1, -1, -1):
		var truth := _waiting[index]
		if shown < truth.tick:
			continue
		if shown <= truth.tick + Truth.TICKS - 1:
			for i: int in truth.ids.size():
				_add(
					distance(
						link.bodies[truth.ids[i]].transform, truth.get_pose(i, shown - truth.tick)
					)
				)
		_waiting.remove_at(index)


func has_errors() -> bool:
	return not _errors.is_empty()


## Median and maximum of the recent errors, in meters.
func get_statistics() -> Vector2:
	var sorted := _errors.duplicate()
	sorted.sort()
	return Vector2(sorted[sorted.size() >> 1], sorted[-1])


## The error between two poses, as defined above.
static func distance(a: Transform3D, b: Transform3D) -> float:
	var offset := b.origin - a.origin
	var worst := offset.length_squared()
	for axis: int in 3:
		worst = maxf(worst, (offset + (b.basis[axis] - a.basis[axis]) * LEVER_ARM).length_squared())
	return sqrt(worst)


func _compare_untimed(truth: Truth, link: PoseLink) -> void:
	for step: int in Truth.TICKS:
		var sum := 0.0
		for i: int in truth.ids.size():
			sum += distance(link.bodies[truth.ids[i]].transform, truth.get_pose(i, step))
		_means[step] = _means[step] * PAST_WEIGHT + sum / truth.ids.size() * (1.0 - PAST_WEIGHT)
	var best := 0
	for step: int in Truth.TICKS:
		best = step if _means[step] < _means[best] else best
	for i: int in truth.ids.size():
		_add(distance(link.bodies[truth.ids[i]].transform, truth.get_pose(i, best)))


func _add(error: float) -> void:
	_errors.append(error)
	if _errors.size() > WINDOW:
		_errors.remove_at(0)
