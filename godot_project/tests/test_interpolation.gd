extends "res://tests/framework/test_case.gd"
## MultivectorLerp's static functions: each mode against an independent computation, degenerate
## poses, and invalid arguments.

const PathReferences := preload("res://tests/framework/path_references.gd")
const Poses := preload("res://tests/framework/poses.gd")

const MODES: Array[MultivectorLerp.Mode] = [
	MultivectorLerp.LINEAR, MultivectorLerp.SCREW, MultivectorLerp.SEPARATE
]
const RANDOM_PAIRS := 300


func test_values_of_modes() -> void:
	expect_equal(int(MultivectorLerp.LINEAR), 0)
	expect_equal(int(MultivectorLerp.SCREW), 1)
	expect_equal(int(MultivectorLerp.SEPARATE), 2)


func test_weights_0_and_1_give_the_ends() -> void:
	var generator := _generator()
	for i in RANDOM_PAIRS:
		var from := Poses.random(generator)
		var to := Poses.random(generator)
		for mode in MODES:
			expect_transform_near(_at(from, to, 0.0, mode), from, 4e-6, "mode %d at 0" % mode)
			expect_transform_near(_at(from, to, 1.0, mode), to, 4e-6, "mode %d at 1" % mode)


func test_linear_is_dual_quaternion_blending() -> void:
	var generator := _generator()
	for i in RANDOM_PAIRS:
		var from := Poses.random(generator)
		var to := Poses.random(generator)
		var weight := generator.randf()
		expect_transform_near(
			_at(from, to, weight, MultivectorLerp.LINEAR),
			PathReferences.linear(from, to, weight),
			4e-5
		)


func test_separate_is_lerp_slerp_lerp() -> void:
	var generator := _generator()
	for i in RANDOM_PAIRS:
		var from := Poses.random(generator)
		var to := Poses.random(generator)
		var weight := generator.randf()
		expect_transform_near(
			_at(from, to, weight, MultivectorLerp.SEPARATE),
			PathReferences.separate(from, to, weight),
			4e-5
		)


func test_repeated_screw_steps_reach_the_end() -> void:
	var generator := _generator()
	for i in RANDOM_PAIRS:
		var from := Poses.random(generator)
		var to := Poses.random(generator)
		var step := _at(from, to, 0.25, MultivectorLerp.SCREW)
		var reached := PathReferences.repeat_motion(from, step, 4)
		# Single-precision errors accumulate over the steps, more so if the pole of the motion is
		# far.
		expect_transform_near(reached, to, 3e-3)


func test_the_screw_path_of_a_door_keeps_its_hinge() -> void:
	var from := Poses.make(Vector3(2, 0, 0))
	var to := Poses.make(Vector3(0, 0, -2), Quaternion(Vector3.UP, PI / 2.0))
	var half := sqrt(2.0)
	var turned := Quaternion(Vector3.UP, PI / 4.0)
	var on_the_arc := Poses.make(Vector3(half, 0, -half), turned)
	expect_transform_near(_at(from, to, 0.5, MultivectorLerp.SCREW), on_the_arc, 1e-6, "screw")
	expect_transform_near(_at(from, to, 0.5, MultivectorLerp.LINEAR), on_the_arc, 1e-6, "linear")
	expect_transform_near(
		_at(from, to, 0.5, MultivectorLerp.SEPARATE),
		Poses.make(Vector3(1, 0, -1), turned),
		1e-6,
		"separate"
	)


func test_scale_is_geometric_on_the_screw_path_only() -> void:
	var from := Poses.make(Vector3.ZERO, Quaternion.IDENTITY, 0.5)
	var to := Poses.make(Vector3(4, 0, 0), Quaternion.IDENTITY, 2.0)
	expect_near(_at(from, to, 0.5, MultivectorLerp.SCREW).basis.x.x, 1.0, 1e-6, "scale of screw")
	expect_near(_at(from, to, 0.5, MultivectorLerp.LINEAR).basis.x.x, 1.25, 1e-6, "scale of linear")
	expect_near(
		_at(from, to, 0.5, MultivectorLerp.SEPARATE).basis.x.x, 1.25, 1e-6, "scale of separate"
	)
	# The screw fixes the center of similarity, here x = -4/3.
	expect_near(
		_at(from, to, 0.5, MultivectorLerp.SCREW).origin.x, 4.0 / 3.0, 1e-6, "center of screw"
	)
	# The implementation of the GA-Unity paper gives a third of this.
	expect_near(_at(from, to, 0.5, MultivectorLerp.LINEAR).origin.x, 2.0, 1e-6, "center of linear")


func test_linear_deviates_by_at_most_8_2_degrees() -> void:
	var from := Transform3D.IDENTITY
	var to := Poses.make(Vector3.ZERO, Quaternion(Vector3.UP, PI - 1e-3))
	var worst := 0.0
	for i in 101:
		var linear := (
			_at(from, to, i / 100.0, MultivectorLerp.LINEAR).basis.get_rotation_quaternion()
		)
		var screw := _at(from, to, i / 100.0, MultivectorLerp.SCREW).basis.get_rotation_quaternion()
		worst = maxf(worst, rad_to_deg(linear.angle_to(screw)))
	expect_near(worst, 8.2, 0.1, "largest deviation in degrees")


func test_the_shorter_rotation_is_taken() -> void:
	# 300 degrees in one direction are 60 in the other.
	var from := Transform3D.IDENTITY
	var to := Poses.make(Vector3.ZERO, Quaternion(Vector3.UP, deg_to_rad(300.0)))
	var expected := Poses.make(Vector3.ZERO, Quaternion(Vector3.UP, deg_to_rad(-30.0)))
	for mode in MODES:
		expect_transform_near(_at(from, to, 0.5, mode), expected, 1e-6, "mode %d" % mode)


func test_q_and_minus_q_give_one_path() -> void:
	var rotation := Quaternion(Vector3(1, 2, 3).normalized(), 1.0)
	var from := Multivector.motor_from(Vector3(1, 0, 0), Quaternion.IDENTITY, 1.0)
	var to := Multivector.motor_from(Vector3(0, 2, 0), rotation, 2.0)
	var to_negative := Multivector.motor_from(Vector3(0, 2, 0), -rotation, 2.0)
	for mode in MODES:
		var one := MultivectorLerp.interpolate(from, to, 0.3, mode).to_transform()
		var other := MultivectorLerp.interpolate(from, to_negative, 0.3, mode).to_transform()
		expect_transform_near(one, other, 1e-6, "mode %d" % mode)


func test_degenerate_pairs_stay_finite_and_uniform() -> void:
	var poses := Poses.degenerate()
	for from_title: String in poses:
		for to_title: String in poses:
			for mode in MODES:
				for weight: float in [0.0, 0.001, 0.5, 1.0]:
					var pose := _at(poses[from_title], poses[to_title], weight, mode)
					_expect_similarity(
						pose, "%s to %s, mode %d at %s" % [from_title, to_title, mode, weight]
					)


func test_far_poses_are_as_exact_as_near_ones() -> void:
	var far := Vector3(Poses.FAR, 0, -Poses.FAR)
	var from := Poses.make(Vector3(2, 0, 0))
	var to := Poses.make(Vector3(0, 0, -2), Quaternion(Vector3.UP, PI / 2.0))
	for mode in MODES:
		var near := _at(from, to, 0.5, mode)
		var there := _at(from.translated(far), to.translated(far), 0.5, mode)
		# The resolution of a single-precision number of this size is half a millimeter.
		expect_transform_near(there, near.translated(far), 2e-3, "mode %d" % mode)


func test_weights_outside_0_to_1() -> void:
	var from := Transform3D.IDENTITY
	var to := Poses.make(Vector3.ZERO, Quaternion(Vector3.UP, 0.5), 2.0)
	var beyond := Poses.make(Vector3.ZERO, Quaternion(Vector3.UP, 1.0), 4.0)
	expect_transform_near(
		_at(from, to, 2.0, MultivectorLerp.SCREW), beyond, 1e-5, "extrapolated screw"
	)
	expect_transform_near(_at(from, to, 2.0, MultivectorLerp.LINEAR), to, 1e-6, "clamped linear")
	expect_transform_near(
		_at(from, to, -1.0, MultivectorLerp.SEPARATE), from, 1e-6, "clamped separate"
	)


func test_motors_and_transforms_agree() -> void:
	var generator := _generator()
	for i in 100:
		var from := Poses.random(generator)
		var to := Poses.random(generator)
		for mode in MODES:
			var motor := MultivectorLerp.interpolate(
				Multivector.motor(from), Multivector.motor(to), 0.6, mode
			)
			expect_transform_near(
				motor.to_transform(), _at(from, to, 0.6, mode), 1e-5, "mode %d" % mode
			)


func test_invalid_transforms_return_the_start() -> void:
	var good := Poses.make(Vector3(1, 2, 3))
	var mirrored := Transform3D(Vector3(-1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3.ZERO)
	expect_error(
		(
			"MultivectorLerp.interpolate_transform: from is mirrored (negative scale), "
			+ "which a motor cannot represent; mirror a child node instead."
		)
	)
	expect_equal(_at(mirrored, good, 0.5, MultivectorLerp.LINEAR), mirrored)
	expect_error(
		(
			"MultivectorLerp.interpolate_transform: to is mirrored (negative scale), which "
			+ "a motor cannot represent; mirror a child node instead."
		)
	)
	expect_equal(_at(good, mirrored, 0.5, MultivectorLerp.LINEAR), good)
	expect_error("MultivectorLerp.interpolate_transform: the weight is not finite.")
	expect_equal(_at(good, good, NAN, MultivectorLerp.SCREW), good)
	for mode: int in [3, (1 << 32) + 1]:
		expect_error(
			"MultivectorLerp: mode %d is invalid; use LINEAR (0), SCREW (1) or SEPARATE (2)." % mode
		)
		expect_equal(_at(good, good, 0.5, mode as MultivectorLerp.Mode), good)


func test_invalid_motors_return_null() -> void:
	var motor := Multivector.scalar(1.0)
	expect_error(
		(
			"MultivectorLerp.interpolate: from is not a motor with a positive scale; "
			+ "create one with Multivector.motor or Multivector.motor_from."
		),
		2
	)
	expect_null(MultivectorLerp.interpolate(null, motor, 0.5, MultivectorLerp.LINEAR))
	expect_null(
		MultivectorLerp.interpolate(Multivector.basis("e1"), motor, 0.5, MultivectorLerp.LINEAR)
	)
	expect_error(
		(
			"MultivectorLerp.interpolate: to is not a motor with a positive scale; create "
			+ "one with Multivector.motor or Multivector.motor_from."
		)
	)
	expect_null(MultivectorLerp.interpolate(motor, null, 0.5, MultivectorLerp.LINEAR))
	expect_error("MultivectorLerp.interpolate: the weight is not finite.")
	expect_null(MultivectorLerp.interpolate(motor, motor, INF, MultivectorLerp.LINEAR))


func _at(
	from: Transform3D, to: Transform3D, weight: float, mode: MultivectorLerp.Mode
) -> Transform3D:
	return MultivectorLerp.interpolate_transform(from, to, weight, mode)


func _expect_similarity(pose: Transform3D, what: String) -> void:
	expect_true(pose.is_finite(), "finiteness of %s" % what)
	var size := pose.basis.x.length()
	expect_true(size > 0.0, "a positive scale of %s" % what)
	expect_near(pose.basis.y.length() / size, 1.0, 1e-5, "uniformity of %s" % what)
	expect_near(
		pose.basis.x.dot(pose.basis.y) / (size * size), 0.0, 1e-5, "right angle of %s" % what
	)
	expect_near(
		pose.basis.determinant() / (size * size * size), 1.0, 1e-5, "handedness of %s" % what
	)


func _generator() -> RandomNumberGenerator:
	var generator := RandomNumberGenerator.new()
	generator.seed = 7
	return generator
