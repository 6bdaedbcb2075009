## The benchmark of the GA-Unity paper: the cost per frame of moving cubes between two poses, by
## several methods ("arms").
##
## godot --headless --path godot_project --script res://tests/bench/engine/engine.gd --
##     --baselines=FILE.gdextension [--sizes=50,250] [--rounds=N] [--arms=NAME,...] [--json=FILE]
##
## The arms take turns of several frames, in an order that is shuffled in each round. A row holds,
## in microseconds, the median and 95th percentile of the whole frame and of the arm's work (the
## time of processing all nodes), and "cost", the measure of the paper: the median frame less that
## of "idle".
extends SceneTree

const BenchRows := preload("res://tests/bench/bench_rows.gd")
const Arm := preload("res://tests/bench/engine/arm.gd")
const Arms := preload("res://tests/bench/engine/arms.gd")
const World := preload("res://tests/bench/engine/world.gd")

const IDLE := "idle"
const WARM_UP_FRAMES := 4
## A turn has as many frames as it takes to move about this many cubes.
const MOVES_PER_TURN := 20_000
const MIN_FRAMES := 6
const MAX_FRAMES := 60

var _rounds := 7
var _chosen := PackedStringArray()


func _initialize() -> void:
	var sizes: PackedInt64Array = [50, 100, 150, 200, 250, 1_000, 10_000]
	var path := ""
	for argument in OS.get_cmdline_user_args():
		var value := argument.get_slice("=", 1)
		match argument.get_slice("=", 0):
			"--baselines":
				_load_baselines(value)
			"--sizes":
				sizes = PackedInt64Array(
					Array(value.split(",")).map(func(size: String) -> int: return size.to_int())
				)
			"--rounds":
				_rounds = value.to_int()
			"--arms":
				_chosen = value.split(",")
				_chosen.append(IDLE)
			"--json":
				path = value
	# A headless engine would sleep between frames.
	OS.low_processor_usage_mode_sleep_usec = 1
	if not ClassDB.class_exists(Arms.NATIVE_CLASS):
		printerr(
			(
				"The C++ baselines are missing: build them with scons bench_engine and pass "
				+ "--baselines=FILE."
			)
		)
		quit(1)
		return
	_measure_all.call_deferred(sizes, path)


func _load_baselines(path: String) -> void:
	var status := GDExtensionManager.load_extension(path)
	if status != GDExtensionManager.LOAD_STATUS_OK:
		printerr("%s could not be loaded: status %d" % [path, status])


func _measure_all(sizes: PackedInt64Array, path: String) -> void:
	var rows: Array[Dictionary] = []
	for size in sizes:
		rows.append_array(await _measure(size))
	quit(BenchRows.write(rows, path))


func _measure(size: int) -> Array[Dictionary]:
	var world := World.new(size)
	root.add_child(world)
	var arms := Arms.make_all(world)
	var frames: Dictionary[String, PackedFloat64Array] = {}
	var works: Dictionary[String, PackedFloat64Array] = {}
	for name: String in arms.keys():
		if not _chosen.is_empty() and name not in _chosen:
			arms[name].free()
			arms.erase(name)
			continue
		frames[name] = PackedFloat64Array()
		works[name] = PackedFloat64Array()
	var order: Array[String] = arms.keys()
	for round_index in _rounds:
		order.shuffle()
		for name in order:
			arms[name].set_active(true)
			await _take_turn(world, size, frames[name], works[name])
			arms[name].set_active(false)
	var rows: Array[Dictionary] = []
	for name in arms:
		rows.append(_row(size, name, frames, works))
		arms[name].free()
	world.free()
	return rows


func _take_turn(
	world: World, size: int, frames: PackedFloat64Array, works: PackedFloat64Array
) -> void:
	var count := clampi(MOVES_PER_TURN / size, MIN_FRAMES, MAX_FRAMES)
	var before := 0
	for frame in WARM_UP_FRAMES + count + 1:
		await process_frame
		# Emitted before nodes are processed, so world.work is that of the frame which began at
		# `before`.
		var began := Time.get_ticks_usec()
		if frame > WARM_UP_FRAMES:
			frames.append(began - before)
			works.append(world.work)
		before = began


func _row(
	size: int,
	name: String,
	frames: Dictionary[String, PackedFloat64Array],
	works: Dictionary[String, PackedFloat64Array]
) -> Dictionary:
	var frame := _quantile(frames[name], 0.5)
	return {
		"subject": name,
		"n": size,
		"frame": frame,
		"frame_p95": _quantile(frames[name], 0.95),
		"cost": frame - _quantile(frames[IDLE], 0.5),
		"work": _quantile(works[name], 0.5),
		"work_p95": _quantile(works[name], 0.95),
		"frames": frames[name].size(),
	}


func _quantile(values: PackedFloat64Array, part: float) -> float:
	var sorted := values.duplicate()
	sorted.sort()
	return sorted[mini(int(sorted.size() * part), sorted.size() - 1)]
