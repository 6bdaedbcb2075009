## From how many bodies on MotorPool gains from several threads: compares calls from the main thread
## with calls from a task of the WorkerThreadPool, where MotorPool uses one thread. Medians of
## alternating rounds.
##
## godot --headless --path godot_project --script res://tests/bench/engine/sharing.gd --
##     [--sizes=1000,...] [--json=FILE]
extends SceneTree

const BenchRows := preload("res://tests/bench/bench_rows.gd")

const ROUNDS := 9
const BODIES_PER_ROUND := 2_000_000
const MODES: Dictionary[String, int] = {
	"interpolate_linear": MultivectorLerp.LINEAR, "interpolate_screw": MultivectorLerp.SCREW
}

var _pool := MotorPool.new()
var _buffer := PackedFloat32Array()
var _usec := 0


func _initialize() -> void:
	var sizes: PackedInt64Array = [4_096, 8_192, 16_384, 32_768, 65_536, 131_072, 1_000_000]
	var path := ""
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with("--sizes="):
			sizes = PackedInt64Array(
				Array(argument.get_slice("=", 1).split(",")).map(
					func(size: String) -> int: return size.to_int()
				)
			)
		elif argument.begins_with("--json="):
			path = argument.get_slice("=", 1)
	var rows: Array[Dictionary] = []
	for size in sizes:
		_fill(size)
		for case in MODES:
			var mode := MODES[case]
			rows.append_array(_measure(case, size, func() -> void: _pool.interpolate(0.4, mode)))
		rows.append_array(
			_measure("set_to_buffer", size, func() -> void: _pool.set_to_buffer(_buffer))
		)
	if path.is_empty():
		for row in rows:
			print(
				(
					"%-20s %9d %-20s %8.2f ns/body"
					% [row["case"], row["n"], row["subject"], row["value"]]
				)
			)
		quit(0)
	else:
		quit(BenchRows.write(rows, path))


func _fill(size: int) -> void:
	_pool.clear()
	_pool.reserve(size)
	for i in size:
		_pool.acquire()
	var random := RandomNumberGenerator.new()
	random.seed = 2026
	_buffer.clear()
	for i in mini(size, 1_000):
		var basis := Basis(
			(
				Quaternion(random.randfn(), random.randfn(), random.randfn(), random.randfn())
				. normalized()
			)
		)
		for row in 3:
			_buffer.append_array(
				[basis.x[row], basis.y[row], basis.z[row], random.randf_range(-10, 10)]
			)
	while _buffer.size() < 12 * size:
		_buffer.append_array(_buffer.slice(0, mini(_buffer.size(), 12 * size - _buffer.size())))
	_pool.set_to_buffer(_buffer)


func _measure(case: String, size: int, call_once: Callable) -> Array[Dictionary]:
	var repeats := maxi(1, BODIES_PER_ROUND / size / (20 if case == "set_to_buffer" else 1))
	var timed := func() -> void:
		var start := Time.get_ticks_usec()
		for i in repeats:
			call_once.call()
		_usec = Time.get_ticks_usec() - start
	var shared := PackedFloat64Array()
	var alone := PackedFloat64Array()
	for round_index in ROUNDS:
		timed.call()
		shared.append(_usec * 1000.0 / repeats / size)
		WorkerThreadPool.wait_for_task_completion(WorkerThreadPool.add_task(timed))
		alone.append(_usec * 1000.0 / repeats / size)
	return [
		_row(case, "motor_pool", size, shared), _row(case, "motor_pool_one_thread", size, alone)
	]


func _row(case: String, subject: String, size: int, times: PackedFloat64Array) -> Dictionary:
	times.sort()
	return {
		"suite": "engine",
		"case": case,
		"subject": subject,
		"n": size,
		"value": times[times.size() / 2],
		"unit": "ns/body"
	}
