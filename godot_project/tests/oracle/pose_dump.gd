extends Node
## Writes pairs of poses and their interpolations by the extension to a file for tests/oracle/run.py
## (its README has the format). Ends the program.

const Poses := preload("res://tests/framework/poses.gd")

const PAIRS := 10000
const SEED := 2024
const MODE_NAMES: Array[String] = ["LINEAR", "SCREW", "SEPARATE"]
## If the cosine of half the angle is below this, both directions of rotation are correct.
const MIN_COSINE := 1e-3
const FILE_ERROR := "--dump-poses: %s cannot be written (%s)."

## The file to write.
var argument := ""

var _from: Array[Transform3D] = []
var _to: Array[Transform3D] = []
var _weights := PackedFloat32Array()
var _separator := "\n"


func _ready() -> void:
	var file := FileAccess.open(argument, FileAccess.WRITE)
	if file == null:
		printerr(FILE_ERROR % [argument, error_string(FileAccess.get_open_error())])
		get_tree().quit(1)
		return
	_make_pairs()
	file.store_string('{"cases": [')
	for mode in MODE_NAMES.size():
		_write_single(file, mode as MultivectorLerp.Mode)
		_write_pool(file, mode as MultivectorLerp.Mode)
	file.store_string("\n]}\n")
	var written := file.get_error()
	file.close()
	if written != OK:
		printerr(FILE_ERROR % [argument, error_string(written)])
		get_tree().quit(1)
		return
	print("%d cases in %s" % [2 * MODE_NAMES.size() * _from.size(), argument])
	get_tree().quit(0)


## The degenerate poses with each other first, then random ones.
func _make_pairs() -> void:
	var generator := RandomNumberGenerator.new()
	generator.seed = SEED
	var degenerate: Array[Transform3D] = []
	degenerate.assign(Poses.degenerate().values())
	for from in degenerate:
		for to in degenerate:
			_add_pair(from, to, generator.randf())
	while _from.size() < PAIRS:
		_add_pair(Poses.random(generator), Poses.random(generator), generator.randf())


func _add_pair(from: Transform3D, to: Transform3D, weight: float) -> void:
	var cosine := from.basis.get_rotation_quaternion().dot(to.basis.get_rotation_quaternion())
	if absf(cosine) > MIN_COSINE:
		_from.append(from)
		_to.append(to)
		_weights.append(weight)


func _write_single(file: FileAccess, mode: MultivectorLerp.Mode) -> void:
	for i in _from.size():
		_write_case(
			file,
			"interpolate_transform",
			i,
			mode,
			MultivectorLerp.interpolate_transform(_from[i], _to[i], _weights[i], mode)
		)


func _write_pool(file: FileAccess, mode: MultivectorLerp.Mode) -> void:
	var pool := MotorPool.new()
	var indices: Array[int] = []
	for i in _from.size():
		indices.append(pool.acquire())
	pool.set_from_all(_from)
	pool.set_to_all(_to)
	pool.interpolate_each(_weights, mode)
	for i in _from.size():
		_write_case(file, "MotorPool", i, mode, pool.get_transform(indices[i]))


func _write_case(
	file: FileAccess, source: String, index: int, mode: MultivectorLerp.Mode, result: Transform3D
) -> void:
	(
		file
		. store_string(
			(
				_separator
				+ (
					JSON
					. stringify(
						{
							"source": source,
							"mode": MODE_NAMES[mode],
							"weight": _weights[index],
							"from": _rows(_from[index]),
							"to": _rows(_to[index]),
							"result": _rows(result),
						},
						"",
						false,
						true
					)
				)
			)
		)
	)
	_separator = ",\n"


func _rows(pose: Transform3D) -> Array[float]:
	var rows: Array[float] = []
	for row in 3:
		rows.append_array(
			[pose.basis.x[row], pose.basis.y[row], pose.basis.z[row], pose.origin[row]]
		)
	return rows
