## MotorPool compared with the engine's Transform3D.interpolate_with, on the same poses in one run.
##
## godot --headless --path godot_project --script res://tests/bench/kernels.gd --
##     [--sizes=1,1000] [--json=FILE]
##
## Rounds alternate between the subjects. A row holds the median of the rounds in nanoseconds per
## pose.
extends SceneTree

const BenchRows := preload("res://tests/bench/bench_rows.gd")

const ROUNDS: int = 7
## A round interpolates at least this many poses.
const POSES_PER_ROUND: int = 40_000

const ENGINE_SUBJECT: String = "transform3d_interpolate_with"
const POOL_SUBJECT: String = "ga_godot"
const MODES: Dictionary[String, int] = {
	"interpolate_linear": MultivectorLerp.LINEAR,
	"interpolate_screw": MultivectorLerp.SCREW,
}

var _from: Array[Transform3D] = []
var _to: Array[Transform3D] = []
var _blended: Array[Transform3D] = []
var _pool: MotorPool = MotorPool.new()


func _initialize() -> void:
	var sizes: PackedInt64Array = [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000]
	var path: String = ""
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--sizes="):
			sizes = PackedInt64Array()
			for size: String in argument.trim_prefix("--sizes=").split(","):
				sizes.append(size.to_int())
		elif argument.begins_with("--json="):
			path = argument.trim_prefix("--json=")
	var rows: Array[Dictionary] = []
	for size: int in sizes:
		_make_poses(size)
		for case: String in MODES:
			rows.append_array(_measure(case, size))
	quit(BenchRows.write(rows, path))


func _make_poses(size: int) -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 2026
	_from.resize(size)
	_to.resize(size)
	_blended.resize(size)
	for i: int in size:
		_from[i] = _random_pose(random)
		_to[i] = _random_pose(random)
	_pool.clear()
	_pool.reserve(size)
	for i: int in size:
		_pool.acquire()
	_pool.set_from_all(_from)
	_pool.set_to_all(_to)


func _random_pose(random: RandomNumberGenerator) -> Transform3D:
	var rotation: Quaternion = (
		Quaternion(random.randfn(), random.randfn(), random.randfn(), random.randfn()).normalized()
	)
	var origin: Vector3 = Vector3(
		random.randf_range(-10, 10), random.randf_range(-10, 10), random.randf_range(-10, 10)
	)
	return Transform3D(Basis(rotation), origin)


func _measure(case: String, size: int) -> Array[Dictionary]:
	var repeats: int = maxi(1, POSES_PER_ROUND / size)
	var engine_times: PackedFloat64Array = PackedFloat64Array()
	var pool_times: PackedFloat64Array = PackedFloat64Array()
	for round_index: int in ROUNDS:
		var weight: float = (round_index + 0.5) / ROUNDS
		engine_times.append(_time_engine(weight, repeats) / (repeats * size))
		# MotorPool is about 50 times as fast; more repeats make its rounds as long.
		pool_times.append(_time_pool(weight, MODES[case], repeats * 50) / (repeats * 50 * size))
	return [
		_row(case, ENGINE_SUBJECT, size, engine_times),
		_row(case, POOL_SUBJECT, size, pool_times),
	]


func _time_engine(weight: float, repeats: int) -> float:
	# GDScript reads local variables faster than members.
	var from: Array[Transform3D] = _from
	var to: Array[Transform3D] = _to
	var blended: Array[Transform3D] = _blended
	var start: int = Time.get_ticks_usec()
	for repeat: int in repeats:
		for i: int in from.size():
			blended[i] = from[i].interpolate_with(to[i], weight)
	return (Time.get_ticks_usec() - start) * 1000.0


func _time_pool(weight: float, mode: int, repeats: int) -> float:
	var start: int = Time.get_ticks_usec()
	for repeat: int in repeats:
		_pool.interpolate(weight, mode)
	return (Time.get_ticks_usec() - start) * 1000.0


func _row(case: String, subject: String, size: int, times: PackedFloat64Array) -> Dictionary:
	times.sort()
	return {
		"suite": "kernels",
		"case": case,
		"subject": subject,
		"n": size,
		"value": times[times.size() / 2],
		"unit": "ns/pose",
		"where": "engine, from GDScript",
	}
