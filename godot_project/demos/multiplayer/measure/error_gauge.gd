extends RefCounted
## A client's own measure of its error: how far what it shows of some moving bodies is from where the server had them,
## at the same media time, at the worst of the body's centre and three points 0.25 m along its axes.
##
## A method that knows which tick it shows is compared at that tick. One that shows what arrives as it arrives is
## compared when the truth arrives, with the one of its ticks that makes the mean error smallest: so the delay of the
## network, and the mean of its own, count for nothing, as in the table of tools/demo.

const PoseLink := preload("../replication/pose_link.gd")
const Truth := preload("truth.gd")

const LEVER := 0.25
## Truths that wait for their tick to be shown, at most.
const MAX_WAITING := 16
## Errors that the figures are over: those of about two seconds.
const WINDOW := 64
## Share of the past in the mean by which the synchronizer's tick is chosen.
const KEPT := 0.95

var _waiting: Array[Truth] = []
var _errors := PackedFloat32Array()
var _means := PackedFloat32Array([0.0, 0.0, 0.0])


## Forgets all: another method begins.
func clear() -> void:
	_waiting.clear()
	_errors.clear()
	_means.fill(0.0)


func take(truth: Truth, link: PoseLink) -> void:
	if not link.is_ready():
		return
	if link.get_shown_tick() >= 0.0:
		_waiting.append(truth)
		if _waiting.size() > MAX_WAITING:
			_waiting.remove_at(0)
	else:
		_compare_untimed(truth, link)


## Call it after each picture.
func update(link: PoseLink) -> void:
	var shown := link.get_shown_tick()
	for at: int in range(_waiting.size() - 1, -1, -1):
		var truth := _waiting[at]
		if shown < truth.tick:
			continue
		if shown <= truth.tick + Truth.TICKS - 1:
			for i: int in truth.ids.size():
				_add(
					distance(
						link.bodies[truth.ids[i]].transform, truth.get_pose(i, shown - truth.tick)
					)
				)
		_waiting.remove_at(at)


func has_errors() -> bool:
	return not _errors.is_empty()


## The median and the largest of the last errors, in metres.
func get_figures() -> Vector2:
	var sorted := _errors.duplicate()
	sorted.sort()
	return Vector2(sorted[sorted.size() >> 1], sorted[-1])


## The largest distance between two poses of a body, at its centre and at three points on its axes.
static func distance(a: Transform3D, b: Transform3D) -> float:
	var offset := b.origin - a.origin
	var worst := offset.length_squared()
	for axis: int in 3:
		worst = maxf(worst, (offset + (b.basis[axis] - a.basis[axis]) * LEVER).length_squared())
	return sqrt(worst)


func _compare_untimed(truth: Truth, link: PoseLink) -> void:
	for step: int in Truth.TICKS:
		var sum := 0.0
		for i: int in truth.ids.size():
			sum += distance(link.bodies[truth.ids[i]].transform, truth.get_pose(i, step))
		_means[step] = _means[step] * KEPT + sum / truth.ids.size() * (1.0 - KEPT)
	var best := 0
	for step: int in Truth.TICKS:
		best = step if _means[step] < _means[best] else best
	for i: int in truth.ids.size():
		_add(distance(link.bodies[truth.ids[i]].transform, truth.get_pose(i, best)))


func _add(error: float) -> void:
	_errors.append(error)
	if _errors.size() > WINDOW:
		_errors.remove_at(0)
