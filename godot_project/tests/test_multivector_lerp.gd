extends "res://tests/framework/test_case.gd"
## The MultivectorLerp node: ends, target, playing, and errors such as missing nodes.

const Poses := preload("res://tests/framework/poses.gd")

const INVALID_MODE := (
	"MultivectorLerp: mode %d is invalid; use LINEAR (0), SCREW (1) or SEPARATE " + "(2)."
)

var _world := Node3D.new()
var _start := Node3D.new()
var _end := Node3D.new()
var _target := Node3D.new()
var _lerp := MultivectorLerp.new()


func test_defaults() -> void:
	expect_equal(_lerp.factor, 0.0, "factor")
	expect_equal(int(_lerp.mode), int(MultivectorLerp.LINEAR), "mode")
	expect_equal(_lerp.local, false, "local")
	expect_equal(_lerp.auto_play, false, "auto_play")
	expect_equal(_lerp.duration, 1.0, "duration")
	expect_equal(_lerp.start, NodePath(), "start")
	expect_null(_lerp.start_motor, "start_motor")
	_free_unused()


func test_deviation_of_two_modes() -> void:
	_free_unused()
	var from := Multivector.motor_from(Vector3.ZERO, Quaternion.IDENTITY, 1.0)
	var to := Multivector.motor_from(Vector3(2, 0, 0), Quaternion(Vector3.UP, PI / 2.0), 1.0)
	# The arc of a rotation by pi / 2 over a chord of 2 m rises by tan(22.5 degrees).
	var found := MultivectorLerp.measure_deviation(
		from, to, MultivectorLerp.SCREW, MultivectorLerp.SEPARATE, 0.0
	)
	expect_near(found["distance"] as float, tan(PI / 8.0), 1e-9, "rise of the arc")
	expect_near(found["distance_weight"] as float, 0.5, 1e-5, "weight of the rise")
	expect_near(found["angle"] as float, 0.0, 1e-9, "angle")
	var with_lever_arm := MultivectorLerp.measure_deviation(
		from, to, MultivectorLerp.LINEAR, MultivectorLerp.SCREW
	)
	expect_near(
		rad_to_deg(with_lever_arm["angle"] as float),
		0.92,
		0.02,
		"largest angle at a rotation by pi / 2"
	)
	expect_true(
		(
			(
				with_lever_arm["distance"] as float
				> (
					MultivectorLerp
					. measure_deviation(
						from, to, MultivectorLerp.LINEAR, MultivectorLerp.SCREW, 0.0
					)["distance"]
				)
			)
			as float
		),
		"a larger distance with a lever arm"
	)


func test_invalid_arguments_of_measure_deviation_are_errors() -> void:
	_free_unused()
	var one := Multivector.scalar(1.0)
	expect_error(
		(
			"MultivectorLerp.measure_deviation: from is not a motor with a positive scale; "
			+ "create one with Multivector.motor or Multivector.motor_from."
		)
	)
	expect_true(
		(
			MultivectorLerp
			. measure_deviation(
				Multivector.basis("e1"), one, MultivectorLerp.LINEAR, MultivectorLerp.SCREW
			)
			. is_empty()
		),
		"an empty dictionary"
	)
	expect_error(
		(
			"MultivectorLerp.measure_deviation: to is not a motor with a positive scale; "
			+ "create one with Multivector.motor or Multivector.motor_from."
		)
	)
	expect_true(
		(
			MultivectorLerp
			. measure_deviation(one, null, MultivectorLerp.LINEAR, MultivectorLerp.SCREW)
			. is_empty()
		),
		"an empty dictionary"
	)
	for lever_arm: float in [-1.0, NAN]:
		expect_error(
			(
				(
					"MultivectorLerp.measure_deviation: lever_arm must be a finite distance of at "
					+ "least 0, "
				)
				+ "not %f." % lever_arm
			)
		)
		expect_true(
			(
				MultivectorLerp
				. measure_deviation(
					one, one, MultivectorLerp.LINEAR, MultivectorLerp.SCREW, lever_arm
				)
				. is_empty()
			),
			"an empty dictionary"
		)
	expect_error(INVALID_MODE % 7)
	expect_true(
		(
			MultivectorLerp
			. measure_deviation(one, one, 7 as MultivectorLerp.Mode, MultivectorLerp.SCREW)
			. is_empty()
		),
		"an empty dictionary"
	)


func test_the_target_is_moved() -> void:
	_build()
	for mode: MultivectorLerp.Mode in [
		MultivectorLerp.LINEAR, MultivectorLerp.SCREW, MultivectorLerp.SEPARATE
	]:
		_lerp.mode = mode
		for factor: float in [0.0, 0.3, 1.0]:
			_lerp.factor = factor
			var expected := MultivectorLerp.interpolate_transform(
				_start.transform, _end.transform, factor, mode
			)
			expect_transform_near(
				_target.transform, expected, 1e-6, "mode %d at %s" % [mode, factor]
			)


func test_moving_ends_are_followed() -> void:
	_build()
	_lerp.factor = 1.0
	_end.position = Vector3(-3, 1, 2)
	await wait_frames(2)
	expect_vector_near(_target.position, Vector3(-3, 1, 2), 1e-5)


func test_world_and_parent_space() -> void:
	_build()
	var other_parent := Node3D.new()
	other_parent.transform = Poses.make(Vector3(10, 20, 30), Quaternion(Vector3.UP, 1.0), 2.0)
	_world.add_child(other_parent)
	_target.reparent(other_parent, false)
	_lerp.target = _lerp.get_path_to(_target)
	_lerp.factor = 0.4
	var expected := MultivectorLerp.interpolate_transform(
		_start.transform, _end.transform, 0.4, MultivectorLerp.LINEAR
	)
	await wait_frames(2)
	expect_transform_near(_target.global_transform, expected, 1e-4, "world space")
	_lerp.local = true
	await wait_frames(2)
	expect_transform_near(_target.transform, expected, 1e-5, "parent space")


func test_motors_take_precedence_over_nodes() -> void:
	_build()
	_lerp.start_motor = Multivector.motor_from(Vector3(0, 5, 0), Quaternion.IDENTITY, 1.0)
	_lerp.end_motor = Multivector.motor_from(Vector3(0, 7, 0), Quaternion.IDENTITY, 1.0)
	_lerp.factor = 0.5
	expect_vector_near(_target.position, Vector3(0, 6, 0), 1e-6)
	_lerp.end_motor.coefficients = Multivector.translator(Vector3(0, 9, 0)).coefficients
	await wait_frames(2)
	expect_vector_near(_target.position, Vector3(0, 7, 0), 1e-6, "after the motor changed in place")


func test_factor_is_clamped_and_nan_is_rejected() -> void:
	_build()
	_lerp.factor = 1.5
	expect_equal(_lerp.factor, 1.0)
	_lerp.factor = -0.5
	expect_equal(_lerp.factor, 0.0)
	_lerp.factor = 0.25
	expect_error("MultivectorLerp: factor must be finite; it is unchanged.")
	_lerp.factor = NAN
	expect_equal(_lerp.factor, 0.25)


func test_invalid_properties_change_nothing() -> void:
	_build()
	_lerp.duration = 3.0
	expect_error("MultivectorLerp: duration must be a positive number of seconds, not %f." % 0.0)
	_lerp.duration = 0.0
	expect_equal(_lerp.duration, 3.0)
	_lerp.mode = MultivectorLerp.SCREW
	expect_error(INVALID_MODE % 3)
	_lerp.mode = 3 as MultivectorLerp.Mode
	expect_equal(int(_lerp.mode), int(MultivectorLerp.SCREW))


func test_playing_reaches_the_end_and_emits_finished() -> void:
	_build()
	var finishes: Array[int] = []
	_lerp.connect(&"finished", finishes.append.bind(1))
	_lerp.duration = 0.1
	_lerp.play()
	expect_true(_lerp.is_playing(), "is_playing after play")
	var frames := 0
	while _lerp.is_playing() and frames < 600:
		await tree.process_frame
		frames += 1
	expect_equal(_lerp.factor, 1.0, "factor")
	expect_equal(finishes.size(), 1, "number of finished signals")
	expect_vector_near(_target.position, _end.position, 1e-5)
	_lerp.play()
	expect_equal(_lerp.factor, 0.0, "factor when played again")
	_lerp.stop()
	expect_true(not _lerp.is_playing(), "stopping")


func test_auto_play() -> void:
	_lerp.auto_play = true
	_lerp.duration = 100.0
	_build()
	expect_true(_lerp.is_playing(), "is_playing after entering the tree")
	await wait_frames(3)
	expect_true(_lerp.factor > 0.0, "progress of the factor")


func test_unset_ends_are_not_an_error() -> void:
	var alone := MultivectorLerp.new()
	add_node(alone)
	alone.factor = 0.5
	await wait_frames(3)
	expect_equal(alone.factor, 0.5)
	_free_unused()


func test_a_missing_node_is_reported_once() -> void:
	_build()
	_lerp.factor = 0.5
	var before := _target.transform
	expect_error(
		(
			'MultivectorLerp: end ("../Nowhere") does not lead to a Node3D in the scene '
			+ "tree; the target is not moved."
		)
	)
	_lerp.end = ^"../Nowhere"
	await wait_frames(5)
	expect_equal(_target.transform, before)
	_lerp.end = ^"../End"
	_lerp.factor = 1.0
	expect_vector_near(_target.position, _end.position, 1e-5, "after repair")


func test_a_freed_end_is_reported_once() -> void:
	_build()
	_lerp.factor = 0.5
	var before := _target.transform
	expect_error(
		(
			'MultivectorLerp: start ("../Start") does not lead to a Node3D in the scene '
			+ "tree; the target is not moved."
		)
	)
	_start.free()
	await wait_frames(5)
	expect_equal(_target.transform, before)


func test_a_freed_target_is_reported_once() -> void:
	_build()
	expect_error(
		(
			'MultivectorLerp: target ("../Target") does not lead to a Node3D in the scene '
			+ "tree; the target is not moved."
		)
	)
	_target.free()
	await wait_frames(5)
	expect_equal(_lerp.factor, 0.0)


func test_a_mirrored_end_is_reported_once() -> void:
	_build()
	_lerp.factor = 0.5
	var before := _target.transform
	expect_error(
		(
			"MultivectorLerp: end is mirrored (negative scale), which a motor cannot "
			+ "represent; mirror a child node instead. The target is not moved."
		)
	)
	_end.scale = Vector3(-1, 1, 1)
	await wait_frames(5)
	expect_equal(_target.transform, before)


func test_an_end_that_is_not_a_motor_is_reported_once() -> void:
	_build()
	_lerp.factor = 0.5
	var before := _target.transform
	expect_error(
		(
			"MultivectorLerp: start is not a motor with a positive scale; create one with "
			+ "Multivector.motor or Multivector.motor_from. The target is not moved."
		)
	)
	_lerp.start_motor = Multivector.basis("e1")
	await wait_frames(5)
	expect_equal(_target.transform, before)


## A world with a start, an end and a target, and the node under test beside them.
func _build() -> void:
	_start.name = "Start"
	_start.transform = Poses.make(Vector3(1, 0, 0), Quaternion(Vector3.UP, 0.2), 0.5)
	_end.name = "End"
	_end.transform = Poses.make(Vector3(0, 3, -2), Quaternion(Vector3.RIGHT, 1.2), 2.5)
	_target.name = "Target"
	_lerp.start = ^"../Start"
	_lerp.end = ^"../End"
	_lerp.target = ^"../Target"
	for node: Node in [_start, _end, _target, _lerp]:
		_world.add_child(node)
	add_node(_world)


func _free_unused() -> void:
	for node: Node in [_world, _start, _end, _target, _lerp]:
		node.free()
