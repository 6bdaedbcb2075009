extends "res://tests/framework/lab_case.gd"
## The playground's interpolation lab, operated through its controls, and the texts that it shows.

const EntryList := preload("res://addons/ga_godot/playground/entries/entry_list.gd")
const LabDrawing := preload("res://addons/ga_godot/playground/lab/lab_drawing.gd")
const LabText := preload("res://addons/ga_godot/playground/lab/lab_text.gd")

## In milliseconds.
const BUDGET := 2.0


func test_folded_it_does_nothing_and_unfolded_it_takes_the_first_two_motors() -> void:
	_open({"S": "sphere(e1, 2)", "k": "0.5", "A": A, "B": B, "C": "translator(e1)"}, false)
	expect_true(_lab_panel.folded, "the panel is folded at first")
	expect_equal(_lab.is_open, false, "open")
	expect_null(_lab.poses.from, "pose while the panel is closed")
	_lab_panel.expand()
	await wait_frames(2)
	expect_equal(_lab.poses.from_name, "A", "from")
	expect_equal(_lab.poses.to_name, "B", "to")
	expect_equal(_lab.poses.get_candidates(), PackedStringArray(["A", "B", "C"]), "candidates")
	expect_equal(
		_scene().get_scene_attributes().size(), 0, "number of attributes, as nothing was chosen"
	)
	expect_equal(_choice("From").get_item_text(_choice("From").selected), "A", "the choice of from")


func test_the_selection_is_used_by_a_click_and_undone() -> void:
	_open({"A": A, "S": "sphere(e1, 1)", "B": B, "C": "rotor(e3, 1)"})
	await wait_frames(8)
	expect_true(_button("UseSelection").disabled, "the button is disabled without a selection")
	_panel.list.select(["S", "A"])
	expect_true(_button("UseSelection").disabled, "the button is disabled for a sphere")
	_panel.list.select(["C", "A"])
	await _click(_button("UseSelection"))
	expect_equal(_setting("from"), "C", "attribute from")
	expect_equal(_setting("to"), "A", "attribute to")
	expect_equal(_lab.poses.from_name, "C", "from")
	await _click(_button("Swap"))
	expect_equal(_lab.poses.from_name, "A", "from, swapped")
	expect_equal(_lab.poses.to_name, "C", "to, swapped")
	_host.own_history.undo()
	expect_equal(_lab.poses.from_name, "C", "from, undone")
	_host.own_history.undo()
	expect_equal(_lab.poses.from_name, "A", "from, undone to the suggestion")
	expect_equal(_lab.poses.to_name, "B", "to, undone to the suggestion")


func test_an_entry_is_chosen_from_the_list() -> void:
	_open({"A": A, "B": B, "C": "rotor(e3, 1)"})
	_choose("To", "C")
	expect_equal(_lab.poses.to_name, "C", "to")
	expect_equal(_setting("from"), "A", "attribute from")
	expect_equal(_setting("to"), "C", "attribute to")


func test_a_drag_of_the_slider_is_one_action() -> void:
	_open({"A": A, "B": B})
	await wait_frames(8)
	var slider: HSlider = _lab_panel.find_child("Slider", true, false)
	var place := slider.get_global_rect()
	await _drag(
		place.position + place.size * Vector2(0.5, 0.5),
		place.position + place.size * Vector2(0.9, 0.5)
	)
	expect_true(_lab.t > 0.8, "t, %s, is near the end" % _lab.t)
	expect_equal(_setting("t"), _lab.t, "attribute t")
	var text: Label = _lab_panel.find_child("Screw", true, false).find_child("Message", true, false)
	var pose := MultivectorLerp.interpolate(
		_scene().get_value("A"), _scene().get_value("B"), _lab.t, MultivectorLerp.SCREW
	)
	expect_equal(text.text, LabText.pose(pose), "text of the pose")
	expect_true(
		(
			text.text.begins_with("at (")
			and text.text.contains("rotated")
			and text.text.contains("scale")
		),
		text.text
	)
	_host.own_history.undo()
	expect_equal(_lab.t, 0.5, "t, undone")
	expect_equal(_host.own_history.has_undo(), false, "another action to undo")


func test_deviations_are_those_of_the_paths() -> void:
	_open({"A": A, "B": B})
	_lab.set_setting(&"lever_arm", 1.5)
	var from := _scene().get_value("A")
	var to := _scene().get_value("B")
	for mode: MultivectorLerp.Mode in [MultivectorLerp.LINEAR, MultivectorLerp.SEPARATE]:
		var distance := 0.0
		var angle := 0.0
		for i in 201:
			var one := MultivectorLerp.interpolate(from, to, i / 200.0, mode)
			var other := MultivectorLerp.interpolate(from, to, i / 200.0, MultivectorLerp.SCREW)
			for k in 60:
				var point := _on_sphere(k, 60) * 1.5
				distance = maxf(
					distance, one.transform_point(point).distance_to(other.transform_point(point))
				)
			var turn := one.get_rotation().inverse() * other.get_rotation()
			angle = maxf(angle, 2.0 * atan2(Vector3(turn.x, turn.y, turn.z).length(), absf(turn.w)))
		var found := _lab.measure(mode, MultivectorLerp.SCREW)
		var measured: float = found["distance"]
		expect_true(
			measured > distance * (1.0 - 1e-5) and measured < distance * 1.05,
			"distance %s is the largest of many points, %s" % [measured, distance]
		)
		expect_near(found["angle"] as float, angle, 1e-3, "angle")
		var row: Node = _lab_panel.find_child(
			"Linear" if mode == MultivectorLerp.LINEAR else "Separate", true, false
		)
		var text: Label = row.find_child("Message", true, false)
		expect_true(
			text.text.ends_with("\n" + LabText.deviation(found)),
			"text of the deviation: %s" % text.text
		)
	expect_equal(
		LabText.deviation(
			{
				"distance": 0.0352,
				"distance_weight": 0.242,
				"angle": deg_to_rad(8.128),
				"angle_weight": 0.25
			}
		),
		"deviation: 35.2 mm (t = 0.24), 8.13° (t = 0.25)"
	)
	expect_equal(
		LabText.deviation(
			{"distance": 1e-9, "distance_weight": 0.2, "angle": 1e-12, "angle_weight": 0.25}
		),
		"no deviation from screw"
	)
	expect_equal(
		LabText.pose(
			Multivector.motor_from(
				Vector3(1, -0.001, 2.5), Quaternion(Vector3.BACK, -0.5 * PI), 2.0
			)
		),
		"at (1.00, 0.00, 2.50), rotated 90.0° about (0.00, 0.00, -1.00), scale 2.00"
	)


func test_it_plays_ping_pong_loop_and_once() -> void:
	_open({"A": A, "B": B})
	_lab.set_setting(&"duration", 2.0)
	_lab.play()
	_lab.advance(0.5)
	expect_near(_lab.t, 0.75, 1e-12, "t after a quarter")
	_lab.advance(1.0)
	expect_near(_lab.t, 0.75, 1e-12, "t while playing backward")
	_lab.stop()
	expect_equal(_setting("t"), null, "attribute t, which playing does not change")
	_lab.set_setting(&"repeat", "loop")
	_lab.play()
	_lab.advance(0.7)
	expect_near(_lab.t, 0.1, 1e-12, "t after the loop restarts")
	_lab.set_setting(&"repeat", "once")
	_lab.advance(5.0)
	expect_equal(_lab.t, 1.0, "t at the end")
	expect_equal(_lab.is_playing(), false, "playing after the end")
	_lab.play()
	_lab.advance(0.5)
	expect_near(_lab.t, 0.25, 1e-12, "t, from the start again")


func test_the_play_button_plays() -> void:
	_open({"A": A, "B": B})
	await wait_frames(8)
	await _click(_button("Play"))
	expect_true(_lab.is_playing(), "playing")
	var before := _lab.t
	await wait_frames(10)
	expect_true(_lab.t != before, "another t")
	await _click(_button("Play"))
	before = _lab.t
	await wait_frames(5)
	expect_equal(_lab.t, before, "t after pausing")
	_lab.play()
	_lab_panel.fold()
	expect_equal(_lab.is_playing(), false, "playing while folded")


func test_it_fits_into_a_narrow_panel() -> void:
	_open({"a_rather_long_name_of_a_pose": A, "another_long_name_of_a_pose": B})
	await wait_frames(8)
	expect_true(
		_lab_panel.get_combined_minimum_size().x <= 250.0,
		"minimum width %s" % _lab_panel.get_combined_minimum_size().x
	)
	var scroll: ScrollContainer = _panel.find_child("Lower", true, false)
	for height: float in [700.0, 500.0, 1600.0]:
		_panel.size.y = height
		await wait_frames(4)
		expect_equal(_panel.size.y, height, "height of the panel")
		expect_true(
			_panel.list.size.y >= EntryList.MIN_HEIGHT,
			"height of the list in %s: %s" % [height, _panel.list.size.y]
		)
		var content: Control = scroll.get_child(0)
		expect_equal(scroll.size.y < content.size.y, height < 1000.0, "scrolling in %s" % height)


func test_a_dragged_pose_is_shown_within_the_budget() -> void:
	_open({"A": A, "B": B})
	add_node(LabDrawing.new(_lab))
	await wait_frames(8)
	var best := INF
	for i in 60:
		_scene().set_parameter("B", "translation", Vector3(0.01 * i, 1, 0.5))
		var start := Time.get_ticks_usec()
		_lab.changed.emit()
		best = minf(best, (Time.get_ticks_usec() - start) / 1000.0)
	print("[lab] panel and drawing after a change of a pose %.3f ms" % best)
	expect_duration_below(best, BUDGET, "a change of a pose")


static func _on_sphere(index: int, count: int) -> Vector3:
	var z := 1.0 - (2.0 * index + 1.0) / count
	var turn := index * PI * (3.0 - sqrt(5.0))
	return Vector3(cos(turn) * sqrt(1.0 - z * z), sin(turn) * sqrt(1.0 - z * z), z)
