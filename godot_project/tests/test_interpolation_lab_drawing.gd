extends "res://tests/framework/test_case.gd"
## The interpolation lab draws poses where MultivectorLerp places them, and follows changes quickly.

const OwnHistory := preload("res://addons/ga_godot/playground/document/own_history.gd")
const PlaygroundDocument := preload(
	"res://addons/ga_godot/playground/document/playground_document.gd"
)
const InterpolationLab := preload("res://addons/ga_godot/playground/lab/interpolation_lab.gd")
const LabDrawing := preload("res://addons/ga_godot/playground/lab/lab_drawing.gd")

const MODES: Array[MultivectorLerp.Mode] = [
	MultivectorLerp.LINEAR, MultivectorLerp.SCREW, MultivectorLerp.SEPARATE
]
const A := "motor(e1 + e2, rotor(e3, 1), 2)"
const B := "motor(3 e3, rotor(e1 + e2, 2), 0.7)"
## For a change of a pose during a drag, in milliseconds.
const BUDGET := 2.0
const REPEATS := 60

var _document := PlaygroundDocument.new(OwnHistory.new())
var _lab := InterpolationLab.new(_document)
var _drawing := LabDrawing.new(_lab)


func test_ghosts_path_and_body_are_where_the_modes_place_them() -> void:
	_open()
	_lab.set_setting(&"ghost_count", 7.0)
	_lab.move(0.3)
	_expect_all_at_their_places(7)
	_document.scene.set_parameter("B", "translation", Vector3(-2, 1, 0.5))
	_expect_all_at_their_places(7)
	_lab.set_setting(&"ghost_count", 24.0)
	_expect_all_at_their_places(24)
	_lab.choose("B", "A")
	_expect_all_at_their_places(24)


func test_poses_that_are_hard_to_interpolate() -> void:
	_open()
	_lab.choose("A", "B")
	for pair: Array in [
		["1", "e12"],
		["rotor(e1, pi)", "-3 rotor(e2, pi)"],
		[A, A],
		[A, "-2 " + A],
		["dilator(0.01)", "dilator(100)"],
		["translator(1e+5, 0, 0)", "translator(1e+5 + 1, 0, 0)"]
	]:
		_document.scene.set_expression("A", pair[0] as String)
		_document.scene.set_expression("B", pair[1] as String)
		expect_true(_drawing.visible, "the drawing is visible: %s, %s" % pair)
		_expect_all_at_their_places(9)


func test_it_draws_what_is_chosen() -> void:
	_open()
	_lab.set_setting(&"separate", false)
	for mode in MODES:
		expect_equal(
			_drawing.get_path_of(mode).visible,
			mode != MultivectorLerp.SEPARATE,
			"visibility of mode %d" % mode
		)
	_lab.set_setting(&"ghosts", false)
	expect_equal(
		_drawing.get_path_of(MultivectorLerp.SCREW).get_ghosts().instance_count, 0, "ghosts"
	)
	var with_frame := _drawing.get_path_of(MultivectorLerp.SCREW).get_body().mesh.get_aabb()
	_lab.set_setting(&"body", "cube")
	var with_cube := _drawing.get_path_of(MultivectorLerp.SCREW).get_body().mesh.get_aabb()
	expect_vector_near(with_cube.get_center(), Vector3.ZERO, 1e-4, "center of the cube")
	expect_near(with_cube.size.x, 0.522, 1e-4, "edge of the cube")
	expect_true(with_frame.get_center().x > 0.2, "axes to one side")
	_lab.set_setting(&"path", false)
	var path: MeshInstance3D = _drawing.get_path_of(MultivectorLerp.SCREW).get_node(^"Path")
	expect_equal(path.visible, false, "visibility of the path")
	_lab.set_setting(&"path", true)
	expect_equal(path.visible, true, "visibility of the path")
	_expect_path(MultivectorLerp.SCREW)


func test_nothing_is_drawn_without_poses_or_while_it_is_closed() -> void:
	_open()
	expect_true(_drawing.visible, "the drawing is visible")
	_document.scene.remove_entry("B")
	expect_equal(_drawing.visible, false, "visibility without a pose")
	_document.scene.add_entry("B", B)
	expect_true(_drawing.visible, "the drawing is visible again")
	_expect_all_at_their_places(9)
	_lab.is_open = false
	expect_equal(_drawing.visible, false, "visibility while closed")
	_document.scene.set_parameter("B", "translation", Vector3(5, 5, 5))
	_lab.is_open = true
	_expect_all_at_their_places(9)


func test_it_follows_another_document() -> void:
	_open()
	var scene := GAScene.new()
	scene.add_entry("C", "translator(e1)")
	scene.add_entry("D", "translator(4 e2)")
	_document.show_scene(scene, "")
	expect_vector_near(
		_drawing.get_path_of(MultivectorLerp.SCREW).get_body().position,
		Vector3(0.5, 2, 0),
		1e-6,
		"body"
	)
	scene.set_expression("D", "translator(6 e2)")
	expect_vector_near(
		_drawing.get_path_of(MultivectorLerp.SCREW).get_body().position,
		Vector3(0.5, 3, 0),
		1e-6,
		"body, followed"
	)


func test_a_dragged_pose_is_followed_within_the_budget() -> void:
	_open()
	# The lab's reaction to a change of a pose with all three modes drawn, without the document's time.
	var best := INF
	for i in REPEATS:
		_document.scene.set_parameter("B", "translation", Vector3(0.01 * i, 1, 0.5))
		var start := Time.get_ticks_usec()
		_lab.changed.emit()
		best = minf(best, (Time.get_ticks_usec() - start) / 1000.0)
	var whole := INF
	for i in REPEATS:
		var start := Time.get_ticks_usec()
		_document.scene.set_parameter("B", "translation", Vector3(0.01 * i, 2, 0.5))
		whole = minf(whole, (Time.get_ticks_usec() - start) / 1000.0)
	var moment := INF
	for i in REPEATS:
		var start := Time.get_ticks_usec()
		_lab.move(0.01 * i)
		moment = minf(moment, (Time.get_ticks_usec() - start) / 1000.0)
	print(
		(
			"[lab] drawing after a change of a pose %.3f ms, with the document %.3f ms, of t %.3f ms"
			% [best, whole, moment]
		)
	)
	expect_duration_below(whole, BUDGET, "a change of a pose")


func _open() -> void:
	var scene := GAScene.new()
	scene.add_entry("A", A)
	scene.add_entry("B", B)
	_document.show_scene(scene, "")
	_lab.is_open = true
	add_node(_drawing)


func _expect_all_at_their_places(count: int) -> void:
	var from := _lab.poses.from
	var to := _lab.poses.to
	var reach := (
		1e-5
		* (
			1.0
			+ from.get_translation().length()
			+ to.get_translation().length()
			+ from.get_scale()
			+ to.get_scale()
		)
	)
	for mode in MODES:
		var buffer := _drawing.get_path_of(mode).get_ghosts().buffer
		expect_equal(buffer.size(), count * 12, "size of the buffer")
		for i in count:
			var motor := MultivectorLerp.interpolate(from, to, i / (count - 1.0), mode)
			expect_transform_near(
				_from_row(buffer, i), motor.to_transform(), reach, "ghost %d of mode %d" % [i, mode]
			)
		var moment := MultivectorLerp.interpolate(from, to, _lab.t, mode)
		expect_transform_near(
			_drawing.get_path_of(mode).get_body().transform,
			moment.to_transform(),
			reach,
			"body of mode %d" % mode
		)
		if from.get_translation().distance_to(to.get_translation()) > 0.1:
			_expect_path(mode)


func _expect_path(mode: MultivectorLerp.Mode) -> void:
	var arrays := _drawing.get_path_of(mode).get_path_mesh().surface_get_arrays(0)
	var vertices: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	expect_equal(vertices.size(), 130, "vertices of the path")
	for i in 65:
		var motor := MultivectorLerp.interpolate(_lab.poses.from, _lab.poses.to, i / 64.0, mode)
		expect_vector_near(
			vertices[2 * i],
			motor.get_translation(),
			1e-5 * (1.0 + motor.get_translation().length()),
			"point %d of the path" % i
		)


func _from_row(buffer: PackedFloat32Array, index: int) -> Transform3D:
	var at := 12 * index
	return Transform3D(
		Vector3(buffer[at], buffer[at + 4], buffer[at + 8]),
		Vector3(buffer[at + 1], buffer[at + 5], buffer[at + 9]),
		Vector3(buffer[at + 2], buffer[at + 6], buffer[at + 10]),
		Vector3(buffer[at + 3], buffer[at + 7], buffer[at + 11])
	)
