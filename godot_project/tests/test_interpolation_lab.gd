extends "res://tests/framework/test_case.gd"
## The playground's interpolation lab, used as a person uses it: folded out, chosen, slid, played, kept, undone.

const GameHost := preload("res://addons/ga_godot/playground/game_host.gd")
const PlaygroundPanel := preload("res://addons/ga_godot/playground/playground_panel.gd")
const InterpolationLab := preload("res://addons/ga_godot/playground/lab/interpolation_lab.gd")
const LabPanel := preload("res://addons/ga_godot/playground/lab/lab_panel.gd")
const LabWords := preload("res://addons/ga_godot/playground/lab/lab_words.gd")

const A := "motor(e1 + e2, rotor(e3, 1), 2)"
const B := "motor(3 e3, rotor(e1 + e2, 2), 0.7)"
const SIZE := Vector2i(250, 1000)

var _host := GameHost.new()
var _view := SubViewport.new()
var _panel: PlaygroundPanel
var _lab: InterpolationLab
var _lab_panel: LabPanel


func test_folded_it_does_nothing_and_unfolded_it_takes_the_first_two_motors() -> void:
	_open({"S": "sphere(e1, 2)", "k": "0.5", "A": A, "B": B, "C": "translator(e1)"}, false)
	expect_true(_lab_panel.folded, "being folded at first")
	expect_equal(_lab.is_open, false, "open")
	expect_null(_lab.poses.from, "pose without being open")
	_lab_panel.expand()
	await wait_frames(2)
	expect_equal(_lab.poses.from_name, "A", "from")
	expect_equal(_lab.poses.to_name, "B", "to")
	expect_equal(_lab.poses.get_candidates(), PackedStringArray(["A", "B", "C"]), "candidates")
	expect_equal(_scene().get_scene_attributes().size(), 0, "number of attributes, as nothing was chosen")
	expect_equal(_choice("From").get_item_text(_choice("From").selected), "A", "what is shown as from")


func test_a_document_that_was_made_with_it_shows_it() -> void:
	_open({"A": A}, false)
	var scene := GAScene.new()
	scene.add_entry("A", A)
	scene.add_entry("B", B)
	scene.set_scene_attribute("interpolation/from", "B")
	scene.set_scene_attribute("interpolation/to", "A")
	scene.set_scene_attribute("interpolation/t", 0.25)
	_panel.document.show_scene(scene, "")
	expect_equal(_lab_panel.folded, false, "folded")
	expect_equal(_lab.poses.from_name, "B", "from")
	expect_equal(_lab.t, 0.25, "t")
	_panel.document.show_scene(GAScene.new(), "")
	expect_equal(_lab_panel.folded, true, "folded with an empty document")


func test_the_selection_is_used_by_a_click_and_undone() -> void:
	_open({"A": A, "S": "sphere(e1, 1)", "B": B, "C": "rotor(e3, 1)"})
	await wait_frames(8)
	expect_true(_button("UseSelection").disabled, "use of no selection being disabled")
	_panel.list.select(["S", "A"])
	expect_true(_button("UseSelection").disabled, "use of a sphere being disabled")
	_panel.list.select(["C", "A"])
	await _click(_button("UseSelection"))
	expect_equal(_setting("from"), "C", "attribute from")
	expect_equal(_setting("to"), "A", "attribute to")
	expect_equal(_lab.poses.from_name, "C", "from")
	await _click(_button("Swap"))
	expect_equal(_lab.poses.from_name, "A", "from, exchanged")
	expect_equal(_lab.poses.to_name, "C", "to, exchanged")
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


func test_the_slider_is_dragged_as_one_step() -> void:
	_open({"A": A, "B": B})
	await wait_frames(8)
	var slider: HSlider = _lab_panel.find_child("Slider", true, false)
	var place := slider.get_global_rect()
	await _drag(place.position + place.size * Vector2(0.5, 0.5), place.position + place.size * Vector2(0.9, 0.5))
	expect_true(_lab.t > 0.8, "t near the end, being %s" % _lab.t)
	expect_equal(_setting("t"), _lab.t, "attribute t")
	var words: Label = _lab_panel.find_child("Screw", true, false).find_child("Words", true, false)
	var pose := MultivectorLerp.interpolate(_scene().get_value("A"), _scene().get_value("B"), _lab.t, MultivectorLerp.SCREW)
	expect_equal(words.text, LabWords.pose(pose), "pose in words")
	expect_true(words.text.begins_with("at (") and words.text.contains("turned") and words.text.contains("scale"), words.text)
	_host.own_history.undo()
	expect_equal(_lab.t, 0.5, "t, undone")
	expect_equal(_host.own_history.has_undo(), false, "more to undo")


func test_deviations_are_those_of_the_paths() -> void:
	_open({"A": A, "B": B})
	_lab.set_setting(&"lever", 1.5)
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
				distance = maxf(distance, one.transform_point(point).distance_to(other.transform_point(point)))
			var turn := one.get_rotation().inverse() * other.get_rotation()
			angle = maxf(angle, 2.0 * atan2(Vector3(turn.x, turn.y, turn.z).length(), absf(turn.w)))
		var found := _lab.measure(mode, MultivectorLerp.SCREW)
		var told: float = found["distance"]
		expect_true(told > distance * (1.0 - 1e-5) and told < distance * 1.05, "distance %s being that of the worst of many points, %s" % [told, distance])
		expect_near(found["angle"] as float, angle, 1e-3, "angle")
		var row: Node = _lab_panel.find_child("Linear" if mode == MultivectorLerp.LINEAR else "Separate", true, false)
		var words: Label = row.find_child("Words", true, false)
		expect_true(words.text.ends_with("\n" + LabWords.deviation(found)), "deviation in words: %s" % words.text)
	expect_equal(LabWords.deviation({"distance": 0.0352, "distance_weight": 0.242, "angle": deg_to_rad(8.128), "angle_weight": 0.25}), "off the screw: 35.2 mm (at t 0.24), 8.13° (at t 0.25)")
	expect_equal(LabWords.deviation({"distance": 1e-9, "distance_weight": 0.2, "angle": 1e-12, "angle_weight": 0.25}), "the same as the screw")
	expect_equal(LabWords.pose(Multivector.motor_from(Vector3(1, -0.001, 2.5), Quaternion(Vector3.BACK, -0.5 * PI), 2.0)), "at (1.00, 0.00, 2.50), turned 90.0° about (0.00, 0.00, -1.00), scale 2.00")


func test_it_plays_there_and_back_around_and_once() -> void:
	_open({"A": A, "B": B})
	_lab.set_setting(&"duration", 2.0)
	_lab.play()
	_lab.advance(0.5)
	expect_near(_lab.t, 0.75, 1e-12, "t after a quarter")
	_lab.advance(1.0)
	expect_near(_lab.t, 0.75, 1e-12, "t on the way back")
	_lab.stop()
	expect_equal(_setting("t"), null, "attribute t, which playing does not change")
	_lab.set_setting(&"repeat", "loop")
	_lab.play()
	_lab.advance(0.7)
	expect_near(_lab.t, 0.1, 1e-12, "t, begun anew")
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


func test_it_is_kept_as_an_entry_that_others_depend_on() -> void:
	_open({"A": A, "B": B})
	_lab.move(0.25)
	var menu: MenuButton = _lab_panel.find_child("Keep", true, false)
	menu.get_popup().id_pressed.emit(MultivectorLerp.SCREW)
	expect_equal(_scene().get_names(), PackedStringArray(["A", "B", "t", "m1"]), "entries")
	expect_equal(_scene().get_expression("m1"), "interpolate_screw(A, B, t)", "expression")
	expect_equal(_scene().get_expression("t"), "0.25", "expression of t")
	expect_equal(_panel.list.selection, PackedStringArray(["m1"]), "selection")
	_expect_kept(0.25)
	_host.own_history.undo()
	expect_equal(_scene().get_names(), PackedStringArray(["A", "B"]), "entries, undone as one step")
	_host.own_history.redo()
	menu.get_popup().id_pressed.emit(MultivectorLerp.LINEAR)
	expect_equal(_scene().get_expression("m2"), "interpolate_linear(A, B, t)", "a second one over the same t")
	_panel.document.change("Slide t", func(scene: GAScene) -> void: scene.set_parameter("t", "value", 0.75))
	expect_equal(_lab.t, 0.75, "the lab's t, following the entry")
	_lab.begin_move()
	_lab.move(0.4)
	_lab.move(0.6)
	_lab.end_move()
	_expect_kept(0.6)
	_host.own_history.undo()
	_expect_kept(0.75)


func test_what_is_played_moves_what_depends_on_it_and_is_one_step() -> void:
	_open({"A": A, "B": B})
	_lab.keep(MultivectorLerp.SCREW)
	_lab.set_setting(&"duration", 1.0)
	_lab.play()
	_lab.advance(0.25)
	_expect_kept(0.75)
	_lab.advance(0.125)
	_expect_kept(0.875)
	_lab.stop()
	_expect_kept(0.875)
	expect_equal(_host.own_history.undo(), "Play t", "step")
	_expect_kept(0.5)
	_panel.document.change("Delete t", func(scene: GAScene) -> void: scene.remove_entry("t"))
	expect_equal(_lab.get_t_entry(), "", "entry of t after it was deleted")
	_lab.move(0.3)
	expect_equal(_lab.t, 0.3, "t by itself")


func test_renamed_entries_are_followed_and_it_says_so() -> void:
	_open({"A": A, "S": "sphere(e1, 1)", "B": B})
	_lab.choose("A", "B")
	_panel.edits.rename("A", "start")
	expect_equal(_lab.poses.from_name, "start", "from")
	expect_equal(_setting("from"), "start", "attribute from")
	expect_equal(_words(), "A is called start now.", "words")
	expect_true(_lab.poses.is_complete(), "poses being there")
	_host.own_history.undo()
	expect_equal(_lab.poses.from_name, "A", "from, undone")
	_host.own_history.redo()
	expect_equal(_lab.poses.from_name, "start", "from, done again")
	_panel.edits.move("B", 0)
	_panel.edits.rename("B", "finish")
	expect_equal(_lab.poses.to_name, "finish", "to, after it was moved")
	_panel.edits.set_expression("finish", "motor(e1, 1)")
	expect_equal(_words(), "", "words after the next change")


func test_deleted_entries_and_others_that_are_no_poses() -> void:
	_open({"A": A, "B": B, "C": "rotor(e3, 1)"})
	_lab.choose("A", "B")
	_panel.edits.remove(["B"])
	expect_equal(_words(), "B is gone: choose another, or undo.", "words")
	expect_equal(_lab.poses.is_complete(), false, "poses being there")
	_host.own_history.undo()
	expect_equal(_words(), "", "words after undoing")
	expect_true(_lab.poses.is_complete(), "poses being there again")
	_panel.edits.set_expression("B", "sphere(e1, 2)")
	expect_equal(_words(), "B is no motor: choose a product of translators, rotors and dilators.", "words of a sphere")
	_panel.edits.set_expression("B", "meet(A")
	expect_true(_words().begins_with("B has no value: column 7: expected ')'"), "words of an error: %s" % _words())
	_choose("To", "C")
	expect_equal(_words(), "", "words after another was chosen")
	expect_true(_lab.poses.is_complete(), "poses being there again")
	_panel.edits.remove(["A", "B", "C"])
	expect_true(_words().contains("A is gone") and _words().contains("C is gone"), "words with nothing left: %s" % _words())
	_panel.document.show_scene(GAScene.new(), "")
	_lab_panel.expand()
	expect_true(_words().begins_with("Add two motors"), "words of an empty document: %s" % _words())


func test_a_pose_that_passes_the_identity_stays_one() -> void:
	_open({"A": "motor(0 e1, rotor(e3, 0), 1)", "B": B})
	expect_equal(_lab.poses.from_name, "A", "from")
	expect_true(_lab.poses.is_complete(), "poses being there")


func test_settings_are_kept_unless_they_are_as_by_default() -> void:
	_open({"A": A, "B": B})
	await wait_frames(8)
	var toggle: CheckBox = _lab_panel.find_child("Separate", true, false).find_child("Toggle", true, false)
	await _click(toggle)
	expect_equal(_setting("separate"), false, "attribute separate")
	expect_equal(_lab.shows_mode(MultivectorLerp.SEPARATE), false, "separate shown")
	await _click(_lab_panel.find_child("Repeat", true, false) as Button)
	expect_equal(_setting("repeat"), "loop", "attribute repeat")
	var path: CheckBox = _lab_panel.find_child("Path", true, false)
	var scroll: ScrollContainer = _lab_panel.find_child("Scroll", true, false)
	scroll.ensure_control_visible(path)
	await wait_frames(8)
	await _click(path)
	expect_equal(_setting("path"), false, "attribute path")
	for i in 3:
		_host.own_history.undo()
	expect_equal(_scene().get_scene_attributes().size(), 0, "number of attributes, undone")
	_lab.set_setting(&"body", "cube")
	_lab.set_setting(&"body", "frame")
	expect_equal(_scene().get_scene_attributes().size(), 0, "number of attributes, as by default again")


func test_attributes_that_cannot_be_are_as_by_default() -> void:
	_open({"A": A, "B": B})
	for attributes: Dictionary in [{"t": "x", "body": "ball", "lever": "long", "from": 3.0}, {"t": -7.0, "ghost_count": 1e9, "duration": 0.0, "t_entry": "A"}]:
		for key: String in attributes:
			_scene().set_scene_attribute("interpolation/" + key, attributes[key])
	expect_equal(_lab.t, 0.0, "t, brought into its range")
	expect_equal(_lab.get_setting(&"ghost_count"), 60.0, "count")
	expect_equal(_lab.get_setting(&"duration"), 0.1, "duration")
	expect_equal(_lab.get_setting(&"body"), "frame", "body")
	expect_equal(_lab.get_setting(&"lever"), 1.0, "lever")
	expect_equal(_lab.get_t_entry(), "", "entry of t")
	expect_equal(_lab.poses.from_name, "A", "from")


func test_it_fits_into_a_narrow_panel() -> void:
	_open({"a_rather_long_name_of_a_pose": A, "another_long_name_of_a_pose": B})
	await wait_frames(8)
	expect_true(_lab_panel.get_combined_minimum_size().x <= 250.0, "least width %s" % _lab_panel.get_combined_minimum_size().x)
	var scroll: ScrollContainer = _lab_panel.find_child("Scroll", true, false)
	expect_true(_panel.list.size.y >= LabPanel.LEAST_LIST - 1.0, "room for the list, %s" % _panel.list.size.y)
	for i in 4:
		# Not in one step: it is no smaller than it needs to be at the time.
		_panel.size.y = 500.0
		await wait_frames(8)
	expect_true(scroll.size.y >= LabPanel.LEAST_HEIGHT - 1.0 and scroll.size.y < LabPanel.LEAST_HEIGHT + 60.0, "height of the lab where there is little room, %s" % scroll.size.y)
	_panel.size.y = 1600.0
	await wait_frames(8)
	expect_equal(scroll.size.y, scroll.get_child(0).get(&"size").y, "height of the lab where there is much room")


func _open(entries: Dictionary, unfolded := true) -> void:
	_panel = PlaygroundPanel.new(_host)
	_panel.size = SIZE
	_view.size = SIZE
	_view.add_child(_panel)
	add_node(_view)
	_lab = _panel.lab
	_lab_panel = _panel.find_child("Interpolation", true, false)
	var scene := GAScene.new()
	for entry: String in entries:
		scene.add_entry(entry, entries[entry] as String)
	_panel.document.show_scene(scene, "")
	if unfolded:
		_lab_panel.expand()


func _scene() -> GAScene:
	return _panel.document.scene


func _setting(key: String) -> Variant:
	return _scene().get_scene_attribute("interpolation/" + key)


func _expect_kept(t: float) -> void:
	expect_near(_lab.t, t, 1e-9, "t")
	var expected := MultivectorLerp.interpolate(_scene().get_value("A"), _scene().get_value("B"), t, MultivectorLerp.SCREW)
	expect_equal(_scene().get_value("m1").coefficients, expected.coefficients, "what is kept, at %s" % t)


func _button(title: String) -> Button:
	return _lab_panel.find_child(title, true, false)


func _choice(title: String) -> OptionButton:
	return _lab_panel.find_child(title, true, false)


func _choose(title: String, entry: String) -> void:
	var choice := _choice(title)
	for index in choice.item_count:
		if choice.get_item_text(index) == entry:
			choice.select(index)
			choice.item_selected.emit(index)
			return


## What is told about the poses.
func _words() -> String:
	var label: Label = _lab_panel.find_child("Ends", true, false).find_child("Words", true, false)
	return label.text if label.visible else ""


func _click(control: Control) -> void:
	await _drag(control.get_global_rect().get_center(), control.get_global_rect().get_center())
	await wait_frames(8)


func _drag(from: Vector2, to: Vector2) -> void:
	for step in 3:
		var place := from if step == 0 else to
		var motion := InputEventMouseMotion.new()
		motion.position = place
		motion.global_position = place
		motion.button_mask = MOUSE_BUTTON_MASK_LEFT if step == 1 else 0 as MouseButtonMask
		if step < 2:
			_view.push_input(motion)
		if step != 1:
			var click := InputEventMouseButton.new()
			click.position = place
			click.global_position = place
			click.button_index = MOUSE_BUTTON_LEFT
			click.pressed = step == 0
			_view.push_input(click)
		await wait_frames(1)


static func _on_sphere(index: int, count: int) -> Vector3:
	var z := 1.0 - (2.0 * index + 1.0) / count
	var turn := index * PI * (3.0 - sqrt(5.0))
	return Vector3(cos(turn) * sqrt(1.0 - z * z), sin(turn) * sqrt(1.0 - z * z), z)
