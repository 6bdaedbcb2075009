extends RefCounted
## What a sender knows about one body: its last key and the poses since.
##
## Keys are chosen by looking back over the ticks since the last one: as long as
## interpolation from the last key to the newest pose stays within the tolerance at every tick
## between, nothing is sent; the pose before it bends becomes the next key. So smooth motion costs
## a key every [constant BodyTimeline.SPAN] ticks and an impact gets keys where it happens.

const BodyTimeline := preload("body_timeline.gd")

## Arm at which a turn is measured, in metres.
const LEVER := 0.25
## Ticks after coming to rest at which the last pose is repeated, because datagrams may be lost.
const REPEATS: Array[int] = [6, 18, 54]

## The last key.
var key_tick := -1
var key_pose := Transform3D.IDENTITY
## True while the body stays where its last key says.
var resting := false

var _recent: Array[Transform3D] = []
var _rested_since := 0
var _repeats_done := 0


## Makes the pose of a tick the last key, as if it had been sent: to everybody, by other means.
func start(tick: int, pose: Transform3D) -> void:
	key_tick = tick
	key_pose = pose
	_recent.clear()
	_rest(tick)


## Takes the pose of the next tick. True if a key has to be sent: [member key_tick], [member key_pose].
func observe(
		tick: int, pose: Transform3D, tolerance: float, rest_tolerance: float, mode := MultivectorLerp.LINEAR) -> bool:
	if resting:
		if distance(key_pose, pose) <= rest_tolerance:
			return false
		# The first key of a motion: until then the receiver holds the resting pose.
		resting = false
		key_tick = tick - 1
		_recent.append(pose)
		return true
	if _bends(pose, tolerance, mode):
		_set_key(tick - 1, _recent[-1])
		_recent.append(pose)
		return true
	_recent.append(pose)
	if _recent.size() < BodyTimeline.SPAN:
		return false
	var rests := _is_within(rest_tolerance)
	_set_key(tick, pose)
	if rests:
		_rest(tick)
	return true


## True at the ticks at which the pose of a resting body is to be sent again.
func take_repeat(tick: int) -> bool:
	if not resting or _repeats_done >= REPEATS.size():
		return false
	if tick - _rested_since < REPEATS[_repeats_done]:
		return false
	_repeats_done += 1
	return true


## The largest distance between two poses of a body, at its centre and at three points on its axes.
static func distance(a: Transform3D, b: Transform3D) -> float:
	var offset := b.origin - a.origin
	return sqrt(maxf(
			maxf(offset.length_squared(), (offset + (b.basis.x - a.basis.x) * LEVER).length_squared()),
			maxf((offset + (b.basis.y - a.basis.y) * LEVER).length_squared(),
				(offset + (b.basis.z - a.basis.z) * LEVER).length_squared())))


func _rest(tick: int) -> void:
	resting = true
	_rested_since = tick
	_repeats_done = 0


func _set_key(tick: int, pose: Transform3D) -> void:
	key_tick = tick
	key_pose = pose
	_recent.clear()


## Whether interpolation from the key to [param pose] leaves the tolerance at a tick between.
func _bends(pose: Transform3D, tolerance: float, mode: MultivectorLerp.Mode) -> bool:
	var count := _recent.size()
	for i: int in count:
		var weight := float(i + 1) / float(count + 1)
		var between := MultivectorLerp.interpolate_transform(key_pose, pose, weight, mode)
		if distance(between, _recent[i]) > tolerance:
			return true
	return false


func _is_within(tolerance: float) -> bool:
	for pose: Transform3D in _recent:
		if distance(key_pose, pose) > tolerance:
			return false
	return true
