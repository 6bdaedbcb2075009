extends "res://tests/framework/test_case.gd"
## The interpolation demo through its user interface: presets, keys, sliders, playback.

const Interpolation := preload("res://demos/interpolation/interpolation.gd")
const Poses := preload("res://tests/framework/poses.gd")
const Preset := preload("res://demos/interpolation/presets.gd")

const MODE_KEYS: Array[Key] = [KEY_1, KEY_2, KEY_3]

var _demo: Interpolation


func test_the_cube_is_where_the_factor_says_in_every_preset_and_mode() -> void:
	_open()
	var presets := Preset.list()
	for i in presets.size():
		_demo.choose_preset(i)
		for mode in MODE_KEYS.size():
			_demo.choose_mode(mode as MultivectorLerp.Mode)
			for factor: float in [0.0, 0.35, 1.0]:
				_demo.set_factor(factor)
				await wait_frames(2)
				var expected := MultivectorLerp.interpolate_transform(
					presets[i].start.to_transform(),
					presets[i].end.to_transform(),
					factor,
					mode as MultivectorLerp.Mode
				)
				expect_transform_near(
					_demo.get_cube().transform,
					expected,
					1e-5,
					"%s, mode %d at %s" % [presets[i].title, mode, factor]
				)


func test_scales_reach_from_half_to_two_and_a_half() -> void:
	_open()
	var scale_slider: HSlider = _demo.find_children("*", "HSlider", true, false)[6]
	expect_equal(scale_slider.min_value, 0.5, "smallest scale")
	expect_equal(scale_slider.max_value, 2.5, "largest scale")


func test_number_keys_choose_the_mode() -> void:
	_open()
	var lerp_node: MultivectorLerp = _demo.get_node(^"Lerp")
	for mode in MODE_KEYS.size():
		_press(MODE_KEYS[mode])
		await wait_frames(2)
		expect_equal(int(lerp_node.mode), mode, "mode")


func test_a_slider_moves_the_pose() -> void:
	_open()
	_demo.choose_preset(5)
	_demo.set_factor(0.0)
	var position_x: HSlider = _demo.find_children("*", "HSlider", true, false)[0]
	position_x.value = 3.25
	await wait_frames(2)
	expect_near(_demo.get_cube().position.x, 3.25, 1e-5, "x of the cube at its start")


func test_space_plays_back_and_forth() -> void:
	_open()
	_demo.set_factor(0.9)
	_press(KEY_SPACE)
	var highest := 0.0
	var lerp_node: MultivectorLerp = _demo.get_node(^"Lerp")
	var turned := false
	var deadline := Time.get_ticks_msec() + 8000.0 * Emulation.get_slowness()
	while not turned and Time.get_ticks_msec() < deadline:
		await tree.process_frame
		highest = maxf(highest, lerp_node.factor)
		turned = highest > 0.99 and lerp_node.factor < highest - 0.05
	expect_true(turned, "the playback reverses at the end (highest factor %s)" % highest)
	_press(KEY_SPACE)
	await wait_frames(2)
	var stopped_at := lerp_node.factor
	await wait_frames(5)
	expect_equal(lerp_node.factor, stopped_at, "factor after stopping")


func test_keys_hide_the_panels() -> void:
	_open()
	var panels: Control = _demo.get_node(^"Interface/Panels")
	_press(KEY_H)
	await wait_frames(2)
	expect_equal(panels.visible, false, "visibility of the panels")
	_press(KEY_H)
	await wait_frames(2)
	expect_equal(panels.visible, true, "visibility of the panels")


func test_ghosts_lie_on_the_path() -> void:
	_open()
	_demo.choose_preset(1)
	var start := Preset.list()[1].start.to_transform()
	var end := Preset.list()[1].end.to_transform()
	for mode in MODE_KEYS.size():
		var ghosts: MultiMeshInstance3D = _demo.get_node(^"Paths").get_child(mode).get_node(
			^"Ghosts"
		)
		var buffer := ghosts.multimesh.buffer
		expect_equal(buffer.size(), 9 * 12, "size of the buffer")
		var middle := MultivectorLerp.interpolate_transform(
			start, end, 0.5, mode as MultivectorLerp.Mode
		)
		var shown := Vector3(buffer[4 * 12 + 3], buffer[4 * 12 + 7], buffer[4 * 12 + 11])
		expect_vector_near(shown, middle.origin, 1e-5, "middle ghost of mode %d" % mode)


func test_deviations_in_millimeters_and_degrees() -> void:
	_open()
	# A rotation by pi of a body 1.8 m from the axis: the arc of the screw path rises 1.8 m over the
	# straight line.
	_demo.choose_preset(1)
	var deviations: GridContainer = _demo.find_child("Deviations", true, false)
	var preset := Preset.list()[1]
	var from := Multivector.motor(preset.start.to_transform())
	var to := Multivector.motor(preset.end.to_transform())
	var pairs: Array[Vector2i] = [Vector2i(0, 1), Vector2i(0, 2), Vector2i(1, 2)]
	for i in pairs.size():
		var farthest := 0.0
		for step in 101:
			var first := MultivectorLerp.interpolate(
				from, to, step / 100.0, pairs[i].x as MultivectorLerp.Mode
			)
			var second := MultivectorLerp.interpolate(
				from, to, step / 100.0, pairs[i].y as MultivectorLerp.Mode
			)
			farthest = maxf(farthest, first.get_translation().distance_to(second.get_translation()))
		var shown: Label = deviations.get_child(3 + 3 * i + 1)
		expect_near(shown.text.to_float(), farthest * 1000.0, 1.0, "distance of pair %d in mm" % i)
	var angle: Label = deviations.get_child(5)
	expect_near(
		angle.text.to_float(),
		8.2,
		0.1,
		"largest angle between linear and screw at a rotation by pi"
	)


func _open() -> void:
	var packed: PackedScene = load("res://demos/interpolation/interpolation.tscn")
	_demo = packed.instantiate()
	add_node(_demo)


func _press(key: Key) -> void:
	for pressed: bool in [true, false]:
		var event := InputEventKey.new()
		event.keycode = key
		event.pressed = pressed
		Input.parse_input_event(event)
