extends "res://tests/framework/test_case.gd"
## MotorPool with many bodies: buffers, snapshots, and results that do not depend on the threads.

const Poses := preload("res://tests/framework/poses.gd")

## Above the number of bodies at which threads are used, and not a multiple of the block size.
const MANY := 70_003
const MODES: Array[MultivectorLerp.Mode] = [
	MultivectorLerp.LINEAR, MultivectorLerp.SCREW, MultivectorLerp.SEPARATE
]
const MILLION := 1_000_000

var _pool := MotorPool.new()


func test_buffers_equal_transforms() -> void:
	var from := _buffer_of(20, 1)
	var to := _buffer_of(20, 2)
	_acquire(_pool, 20)
	_pool.set_from_buffer(from)
	_pool.set_to_buffer(to)
	var other := MotorPool.new()
	_acquire(other, 20)
	other.set_from_all(_transforms_of(from))
	other.set_to_all(_transforms_of(to))
	for mode in MODES:
		_pool.interpolate(0.3, mode)
		other.interpolate(0.3, mode)
		expect_equal(_pool.get_buffer(), other.get_buffer(), "mode %d" % mode)
	_pool.interpolate(1.0, MultivectorLerp.LINEAR)
	for i in to.size():
		expect_near(_pool.get_buffer()[i], to[i], 4e-5, "float %d at the end" % i)


func test_an_invalid_buffer_changes_nothing() -> void:
	_acquire(_pool, 2)
	var good := _buffer_of(2, 3)
	_pool.set_from_buffer(good)
	_pool.set_to_buffer(good)
	expect_error(
		(
			"MotorPool.set_from_buffer: the buffer has 13 floats, which is not a multiple "
			+ "of 12; pass 12 floats per body."
		)
	)
	var odd := PackedFloat32Array()
	odd.resize(13)
	_pool.set_from_buffer(odd)
	expect_error(
		(
			"MotorPool.set_to_buffer: got 3 rows for 2 bodies; pass one per body, in the "
			+ "order of acquire()."
		)
	)
	_pool.set_to_buffer(_buffer_of(3, 4))
	var bad := _buffer_of(2, 5)
	bad[12] = NAN
	expect_error(
		(
			"MotorPool.set_to_buffer: the transform at index 1 has a value that is not "
			+ "finite (NaN or infinity); check where it was computed. No pose was changed."
		)
	)
	_pool.set_to_buffer(bad)
	_pool.interpolate(0.5, MultivectorLerp.LINEAR)
	for i in good.size():
		expect_near(_pool.get_buffer()[i], good[i], 4e-5, "float %d" % i)


func test_advance_makes_the_to_pose_the_from_pose() -> void:
	var snapshots: Array[PackedFloat32Array] = [
		_buffer_of(9, 6), _buffer_of(9, 7), _buffer_of(9, 8)
	]
	_acquire(_pool, 9)
	for snapshot in snapshots:
		_pool.advance()
		_pool.set_to_buffer(snapshot)
	var other := MotorPool.new()
	_acquire(other, 9)
	other.set_from_buffer(snapshots[1])
	other.set_to_buffer(snapshots[2])
	for mode in MODES:
		_pool.interpolate(0.6, mode)
		other.interpolate(0.6, mode)
		for i in 12 * 9:
			expect_near(
				_pool.get_buffer()[i],
				other.get_buffer()[i],
				1e-5,
				"float %d in mode %d" % [i, mode]
			)
	_pool.advance()
	_pool.interpolate(0.5, MultivectorLerp.SCREW)
	for i in 12 * 9:
		expect_near(_pool.get_buffer()[i], snapshots[2][i], 4e-5, "float %d at rest" % i)


func test_a_kept_buffer_does_not_change() -> void:
	_acquire(_pool, 9)
	_pool.set_to_buffer(_buffer_of(9, 13))
	_pool.interpolate(0.25, MultivectorLerp.LINEAR)
	var first := _pool.get_buffer()
	var copy := first.slice(0)
	_pool.interpolate(0.75, MultivectorLerp.LINEAR)
	var second := _pool.get_buffer()
	expect_equal(first, copy, "the first buffer")
	expect_true(first != second, "a difference between the two")
	var index := _pool.acquire()
	_pool.interpolate(0.25, MultivectorLerp.LINEAR)
	expect_equal(
		_pool.get_buffer().slice(0, 12 * 9), copy, "the same weight again, beside a new body"
	)
	expect_equal(_pool.get_transform(index), Transform3D.IDENTITY, "the new body")
	_pool.release(index)
	_pool.interpolate(0.75, MultivectorLerp.LINEAR)
	expect_equal(_pool.get_buffer(), second, "the other weight again, without it")


## One pool with several threads, the same pool in one thread, and a separate pool for each part.
func test_results_do_not_depend_on_the_threads() -> void:
	var from := _buffer_of(MANY, 9)
	var to := _buffer_of(MANY, 10)
	var weights := PackedFloat32Array()
	for i in MANY:
		weights.append(fmod(i * 0.137, 1.0))
	_acquire(_pool, MANY)
	_pool.set_from_buffer(from)
	_pool.set_to_buffer(to)
	for mode in MODES:
		_pool.interpolate_each(weights, mode)
		var shared := _pool.get_buffer()
		expect_equal(
			_in_one_thread(func() -> void: _pool.interpolate_each(weights, mode)),
			shared,
			"one thread, mode %d" % mode
		)
		expect_equal(_in_parts(from, to, weights, mode), shared, "many pools, mode %d" % mode)


func test_the_first_invalid_pose_is_reported() -> void:
	_acquire(_pool, MANY)
	var bad := _buffer_of(MANY, 11)
	for row: int in [MANY - 1, 30_000, 7_777, 25_000]:
		bad[12 * row] = NAN
	expect_error(
		(
			"MotorPool.set_from_buffer: the transform at index 7777 has a value that is "
			+ "not finite (NaN or infinity); check where it was computed. No pose was "
			+ "changed."
		)
	)
	_pool.set_from_buffer(bad)
	_pool.interpolate(0.0, MultivectorLerp.LINEAR)
	expect_equal(_pool.get_transform(0), Transform3D.IDENTITY, "the first body")
	expect_equal(_pool.get_transform(MANY - 1), Transform3D.IDENTITY, "the last body")


func test_indices_survive_growth() -> void:
	var living := PackedInt64Array()
	for i in 5_000:
		var index := _pool.acquire()
		_pool.set_from(index, Transform3D(Basis.IDENTITY, Vector3(i, 0, 0)))
		_pool.set_to(index, Transform3D(Basis.IDENTITY, Vector3(i, 2, 0)))
		living.append(index)
	for i in range(0, 5_000, 3):
		_pool.release(living[i])
	_acquire(_pool, 20_000)
	_pool.interpolate(0.5, MultivectorLerp.LINEAR)
	expect_equal(_pool.get_count(), 5_000 - 1_667 + 20_000, "count")
	for i: int in [1, 2, 4, 1_000, 4_999]:
		expect_vector_near(
			_pool.get_transform(living[i]).origin, Vector3(i, 1, 0), 1e-6, "body %d" % i
		)


func test_a_million_bodies() -> void:
	_pool.reserve(MILLION)
	_acquire(_pool, MILLION)
	var to := _buffer_of(1_000, 12)
	while to.size() < 12 * MILLION:
		to.append_array(to.slice(0, mini(to.size(), 12 * MILLION - to.size())))
	_pool.set_to_buffer(to)
	_pool.interpolate(0.5, MultivectorLerp.LINEAR)
	var buffer := _pool.get_buffer()
	expect_equal(buffer.size(), 12 * MILLION, "size of the buffer")
	expect_equal(
		buffer.slice(12 * 999_000), buffer.slice(0, 12_000), "the last thousand beside the first"
	)
	var pose := Transform3D.IDENTITY
	var expected := MultivectorLerp.interpolate_transform(
		pose, _transforms_of(to.slice(0, 12))[0], 0.5, MultivectorLerp.LINEAR
	)
	expect_transform_near(_pool.get_transform(999_000), expected, 4e-5, "body 999,000")
	_pool.clear()
	expect_equal(_pool.get_count(), 0, "count after clear")


func _acquire(pool: MotorPool, count: int) -> void:
	for i in count:
		pool.acquire()


func _in_one_thread(work: Callable) -> PackedFloat32Array:
	_pool.interpolate(0.0, MultivectorLerp.LINEAR)
	WorkerThreadPool.wait_for_task_completion(WorkerThreadPool.add_task(work))
	return _pool.get_buffer()


func _in_parts(
	from: PackedFloat32Array,
	to: PackedFloat32Array,
	weights: PackedFloat32Array,
	mode: MultivectorLerp.Mode
) -> PackedFloat32Array:
	var buffer := PackedFloat32Array()
	for first in range(0, MANY, 3_001):
		var end := mini(first + 3_001, MANY)
		var part := MotorPool.new()
		_acquire(part, end - first)
		part.set_from_buffer(from.slice(12 * first, 12 * end))
		part.set_to_buffer(to.slice(12 * first, 12 * end))
		part.interpolate_each(weights.slice(first, end), mode)
		buffer.append_array(part.get_buffer())
	return buffer


func _buffer_of(count: int, seed_number: int) -> PackedFloat32Array:
	var generator := RandomNumberGenerator.new()
	generator.seed = seed_number
	var buffer := PackedFloat32Array()
	for i in count:
		var pose := Poses.random(generator)
		for row in 3:
			buffer.append_array(
				[pose.basis.x[row], pose.basis.y[row], pose.basis.z[row], pose.origin[row]]
			)
	return buffer


func _transforms_of(buffer: PackedFloat32Array) -> Array[Transform3D]:
	var transforms: Array[Transform3D] = []
	for i in range(0, buffer.size(), 12):
		transforms.append(
			Transform3D(
				Vector3(buffer[i], buffer[i + 4], buffer[i + 8]),
				Vector3(buffer[i + 1], buffer[i + 5], buffer[i + 9]),
				Vector3(buffer[i + 2], buffer[i + 6], buffer[i + 10]),
				Vector3(buffer[i + 3], buffer[i + 7], buffer[i + 11])
			)
		)
	return transforms
