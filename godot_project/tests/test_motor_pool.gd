extends "res://tests/framework/test_case.gd"
## MotorPool: acquiring and releasing bodies, and agreement of interpolation with MultivectorLerp.

const Poses := preload("res://tests/framework/poses.gd")

const MODES: Array[MultivectorLerp.Mode] = [
	MultivectorLerp.LINEAR, MultivectorLerp.SCREW, MultivectorLerp.SEPARATE
]
const INVALID_INDEX := "MotorPool.%s: index %d is not a live index returned by acquire()."
const INVALID_MODE := (
	"MotorPool.%s: mode %d is invalid; use MultivectorLerp.LINEAR (0), SCREW (1) "
	+ "or SEPARATE (2)."
)
const MIRRORED := Transform3D(Vector3(-1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3.ZERO)

var _pool := MotorPool.new()


func test_a_new_body_is_at_the_origin() -> void:
	_pool.reserve(4)
	expect_equal(_pool.get_count(), 0, "count after reserve")
	var index := _pool.acquire()
	expect_equal(_pool.get_count(), 1, "count")
	expect_equal(_pool.get_transform(index), Transform3D.IDENTITY)
	_pool.interpolate(0.5, MultivectorLerp.SCREW)
	expect_transform_near(_pool.get_transform(index), Transform3D.IDENTITY, 1e-7)


## With counts below, at and above the size of a block, 8.
func test_every_body_agrees_with_interpolate_transform() -> void:
	for count: int in [1, 7, 8, 9, 40]:
		_pool.clear()
		var from := _random_poses(count, 1)
		var to := _random_poses(count, 2)
		var indices := _fill(from, to)
		for mode in MODES:
			_pool.interpolate(0.35, mode)
			for i in count:
				var expected := MultivectorLerp.interpolate_transform(from[i], to[i], 0.35, mode)
				expect_transform_near(
					_pool.get_transform(indices[i]),
					expected,
					4e-5,
					"body %d of %d, mode %d" % [i, count, mode]
				)


func test_each_body_with_its_own_weight() -> void:
	var from := _random_poses(13, 3)
	var to := _random_poses(13, 4)
	var indices := _fill(from, to)
	var weights := PackedFloat32Array()
	for i in 13:
		weights.append(i / 12.0)
	for mode in MODES:
		_pool.interpolate_each(weights, mode)
		for i in 13:
			var expected := MultivectorLerp.interpolate_transform(from[i], to[i], weights[i], mode)
			expect_transform_near(
				_pool.get_transform(indices[i]), expected, 4e-5, "body %d, mode %d" % [i, mode]
			)


func test_setting_all_equals_setting_one_by_one() -> void:
	var from := _random_poses(11, 5)
	var to := _random_poses(11, 6)
	_fill(from, to)
	_pool.interpolate(0.8, MultivectorLerp.SCREW)
	var one_by_one := _pool.get_buffer()
	var other := MotorPool.new()
	for i in 11:
		other.acquire()
	other.set_from_all(from)
	other.set_to_all(to)
	other.interpolate(0.8, MultivectorLerp.SCREW)
	expect_equal(other.get_buffer(), one_by_one)


func test_degenerate_pairs_agree_and_stay_finite() -> void:
	var poses: Array[Transform3D] = []
	poses.assign(Poses.degenerate().values())
	for shift in poses.size():
		_pool.clear()
		var to: Array[Transform3D] = []
		for i in poses.size():
			to.append(poses[(i + shift) % poses.size()])
		var indices := _fill(poses, to)
		for mode in MODES:
			_pool.interpolate(0.5, mode)
			for i in poses.size():
				var pose := _pool.get_transform(indices[i])
				expect_true(
					pose.is_finite(), "finiteness of pair %d, %d in mode %d" % [i, shift, mode]
				)
				_expect_agreement(pose, poses[i], to[i], mode)


func test_the_motor_of_a_body() -> void:
	var indices := _fill(
		[Transform3D.IDENTITY], [Poses.make(Vector3(2, 4, 6), Quaternion(Vector3.UP, 1.0), 3.0)]
	)
	_pool.interpolate(1.0, MultivectorLerp.LINEAR)
	var motor := _pool.get_motor(indices[0])
	expect_true(motor.is_motor(), "is_motor")
	expect_transform_near(motor.to_transform(), _pool.get_transform(indices[0]), 1e-6)


func test_the_buffer_has_12_floats_a_body_row_by_row() -> void:
	var pose := Transform3D(
		Basis(Quaternion(Vector3.UP, PI / 2.0)).scaled(Vector3.ONE * 2.0), Vector3(5, 6, 7)
	)
	_fill([Transform3D.IDENTITY, pose], [Transform3D.IDENTITY, pose])
	_pool.interpolate(0.0, MultivectorLerp.LINEAR)
	var buffer := _pool.get_buffer()
	expect_equal(buffer.size(), 24, "size of the buffer")
	# A rotation by pi / 2 about y takes x to -z and z to x.
	var row: Array[float] = [0, 0, 2, 5, 0, 2, 0, 6, -2, 0, 0, 7]
	for i in 12:
		expect_near(buffer[12 + i], row[i], 1e-6, "float %d of the second body" % i)


func test_releasing_keeps_other_bodies() -> void:
	var from := _random_poses(20, 8)
	var indices := _fill(from, from)
	for i: int in [0, 7, 8, 19]:
		_pool.release(indices[i])
	expect_equal(_pool.get_count(), 16, "count")
	_pool.interpolate(0.0, MultivectorLerp.SEPARATE)
	expect_equal(_pool.get_buffer().size(), 16 * 12, "size of the buffer")
	for i: int in [1, 6, 9, 18]:
		expect_transform_near(_pool.get_transform(indices[i]), from[i], 4e-6, "body %d" % i)
	# The remaining rows of the buffer move up: body 9 is now the seventh row.
	expect_near(_pool.get_buffer()[6 * 12 + 3], from[9].origin.x, 4e-6, "x of the row of body 9")


func test_a_released_index_stays_invalid() -> void:
	var index := _pool.acquire()
	_pool.release(index)
	var next := _pool.acquire()
	expect_true(next != index, "difference of a used index and a new one")
	expect_error(INVALID_INDEX % ["release", index])
	_pool.release(index)
	expect_error(INVALID_INDEX % ["set_from", index])
	_pool.set_from(index, Transform3D.IDENTITY)
	expect_error(INVALID_INDEX % ["set_to", index])
	_pool.set_to(index, Transform3D.IDENTITY)
	expect_error(INVALID_INDEX % ["get_transform", index])
	expect_equal(_pool.get_transform(index), Transform3D.IDENTITY)
	expect_error(INVALID_INDEX % ["get_motor", index])
	expect_null(_pool.get_motor(index))
	expect_equal(_pool.get_count(), 1, "count")


func test_indices_not_from_acquire_are_errors() -> void:
	for index: int in [-1, 0, 5, 1 << 40]:
		expect_error(INVALID_INDEX % ["release", index])
		_pool.release(index)
	expect_equal(_pool.get_count(), 0)


func test_clear_invalidates_all_indices() -> void:
	var index := _pool.acquire()
	_pool.clear()
	expect_equal(_pool.get_count(), 0, "count")
	expect_equal(_pool.get_buffer().size(), 0, "size of the buffer")
	expect_error(INVALID_INDEX % ["get_transform", index])
	_pool.get_transform(index)
	_pool.acquire()
	expect_error(INVALID_INDEX % ["get_transform", index])
	_pool.get_transform(index)


func test_an_invalid_pose_changes_nothing() -> void:
	var good := Poses.make(Vector3(1, 2, 3))
	var indices := _fill([good, good], [good, good])
	var reason := (
		"is mirrored (negative scale), which a motor cannot represent; mirror a child "
		+ "node instead"
	)
	expect_error("MotorPool.set_from: the transform for index %d %s." % [indices[1], reason])
	_pool.set_from(indices[1], MIRRORED)
	expect_error("MotorPool.set_to: the transform for index %d %s." % [indices[1], reason])
	_pool.set_to(indices[1], MIRRORED)
	var bad: Array[Transform3D] = [Transform3D.IDENTITY, MIRRORED]
	expect_error(
		"MotorPool.set_from_all: the transform at index 1 %s. No pose was changed." % reason
	)
	_pool.set_from_all(bad)
	expect_error("MotorPool.set_to_all: the transform at index 1 %s. No pose was changed." % reason)
	_pool.set_to_all(bad)
	_pool.interpolate(0.5, MultivectorLerp.LINEAR)
	for index in indices:
		expect_transform_near(_pool.get_transform(index), good, 1e-6)


func test_array_sizes_must_match_the_count() -> void:
	_pool.acquire()
	var three: Array[Transform3D] = [
		Transform3D.IDENTITY, Transform3D.IDENTITY, Transform3D.IDENTITY
	]
	expect_error(
		(
			"MotorPool.set_from_all: got 3 transforms for 1 bodies; pass one per body, in "
			+ "the order of acquire()."
		)
	)
	_pool.set_from_all(three)
	expect_error(
		(
			"MotorPool.set_to_all: got 3 transforms for 1 bodies; pass one per body, in "
			+ "the order of acquire()."
		)
	)
	_pool.set_to_all(three)
	expect_error(
		(
			"MotorPool.interpolate_each: got 2 weights for 1 bodies; pass one per body, in "
			+ "the order of acquire()."
		)
	)
	_pool.interpolate_each(PackedFloat32Array([0.0, 1.0]), MultivectorLerp.LINEAR)
	expect_error("MotorPool.reserve: count -1 is not in 0..16777216.")
	_pool.reserve(-1)
	expect_equal(_pool.get_count(), 1)


func test_invalid_weights_and_modes_change_nothing() -> void:
	var indices := _fill([Transform3D.IDENTITY], [Poses.make(Vector3(2, 0, 0))])
	_pool.interpolate(0.5, MultivectorLerp.LINEAR)
	expect_error("MotorPool.interpolate: the weight is not finite.")
	_pool.interpolate(NAN, MultivectorLerp.LINEAR)
	expect_error(
		"MotorPool.interpolate_each: the weight at index 0 is not finite. No pose was changed."
	)
	_pool.interpolate_each(PackedFloat32Array([INF]), MultivectorLerp.LINEAR)
	expect_error(INVALID_MODE % ["interpolate", -1])
	_pool.interpolate(0.5, -1 as MultivectorLerp.Mode)
	expect_error(INVALID_MODE % ["interpolate_each", 7])
	_pool.interpolate_each(PackedFloat32Array([0.0]), 7 as MultivectorLerp.Mode)
	expect_vector_near(_pool.get_transform(indices[0]).origin, Vector3(1, 0, 0), 1e-6)


func test_an_empty_pool_does_nothing() -> void:
	_pool.interpolate(0.5, MultivectorLerp.SCREW)
	_pool.interpolate_each(PackedFloat32Array(), MultivectorLerp.SCREW)
	_pool.set_from_all([] as Array[Transform3D])
	_pool.apply_to_nodes([] as Array[Node3D])
	expect_equal(_pool.get_buffer().size(), 0)


func _fill(from: Array[Transform3D], to: Array[Transform3D]) -> Array[int]:
	var indices: Array[int] = []
	for i in from.size():
		indices.append(_pool.acquire())
		_pool.set_from(indices[i], from[i])
		_pool.set_to(indices[i], to[i])
	return indices


func _random_poses(count: int, seed_number: int) -> Array[Transform3D]:
	var generator := RandomNumberGenerator.new()
	generator.seed = seed_number
	var poses: Array[Transform3D] = []
	for i in count:
		poses.append(Poses.random(generator))
	return poses


## The pool computes in single precision. For a rotation by pi, both directions are correct.
func _expect_agreement(
	pose: Transform3D, from: Transform3D, to: Transform3D, mode: MultivectorLerp.Mode
) -> void:
	var cosine := from.basis.get_rotation_quaternion().dot(to.basis.get_rotation_quaternion())
	if absf(cosine) < 1e-3:
		return
	var expected := MultivectorLerp.interpolate_transform(from, to, 0.5, mode)
	var size := maxf(
		maxf(from.origin.length(), to.origin.length()),
		maxf(from.basis.x.length(), to.basis.x.length())
	)
	expect_transform_near(
		pose, expected, 1e-5 * maxf(1.0, size), "%s to %s in mode %d" % [from, to, mode]
	)
