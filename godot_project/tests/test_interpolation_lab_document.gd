extends "res://tests/framework/lab_case.gd"
## The interpolation lab and its document: stored settings, added entries, and changes to entries.


func test_it_unfolds_for_a_document_that_has_its_settings() -> void:
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


func test_it_is_added_as_an_entry_that_others_can_depend_on() -> void:
	_open({"A": A, "B": B})
	_lab.move(0.25)
	var menu: MenuButton = _lab_panel.find_child("AddEntry", true, false)
	menu.get_popup().id_pressed.emit(MultivectorLerp.SCREW)
	expect_equal(_scene().get_names(), PackedStringArray(["A", "B", "t", "m1"]), "entries")
	expect_equal(_scene().get_expression("m1"), "interpolate_screw(A, B, t)", "expression")
	expect_equal(_scene().get_expression("t"), "0.25", "expression of t")
	expect_equal(_panel.list.selection, PackedStringArray(["m1"]), "selection")
	_expect_kept(0.25)
	_host.own_history.undo()
	expect_equal(_scene().get_names(), PackedStringArray(["A", "B"]), "entries after one undo")
	_host.own_history.redo()
	menu.get_popup().id_pressed.emit(MultivectorLerp.LINEAR)
	expect_equal(
		_scene().get_expression("m2"), "interpolate_linear(A, B, t)", "a second one over the same t"
	)
	_panel.document.change(
		"Slide t", func(scene: GAScene) -> void: scene.set_parameter("t", "value", 0.75)
	)
	expect_equal(_lab.t, 0.75, "the lab's t, following the entry")
	_lab.begin_move()
	_lab.move(0.4)
	_lab.move(0.6)
	_lab.end_move()
	_expect_kept(0.6)
	_host.own_history.undo()
	_expect_kept(0.75)
	_lab.begin_move()
	_scene().remove_entry("t")
	_lab.end_move()
	expect_equal(
		_panel.document.is_in_gesture(),
		false,
		"whether a gesture continues after its entry was removed"
	)


func test_playback_moves_dependents_and_is_one_action() -> void:
	_open({"A": A, "B": B})
	_lab.add_entry(MultivectorLerp.SCREW)
	_lab.set_setting(&"duration", 1.0)
	_lab.play()
	_lab.advance(0.25)
	_expect_kept(0.75)
	_lab.advance(0.125)
	_expect_kept(0.875)
	_lab.stop()
	_expect_kept(0.875)
	expect_equal(_host.own_history.undo(), "Play t", "undone action")
	_expect_kept(0.5)
	_panel.document.change("Delete t", func(scene: GAScene) -> void: scene.remove_entry("t"))
	expect_equal(_lab.get_t_entry(), "", "entry of t after it was deleted")
	_lab.move(0.3)
	expect_equal(_lab.t, 0.3, "t without an entry")


func test_renamed_entries_are_followed_and_reported() -> void:
	_open({"A": A, "S": "sphere(e1, 1)", "B": B})
	_lab.choose("A", "B")
	_panel.edits.rename("A", "start")
	expect_equal(_lab.poses.from_name, "start", "from")
	expect_equal(_setting("from"), "start", "attribute from")
	expect_equal(_message(), "A was renamed to start.", "message")
	expect_true(_lab.poses.is_complete(), "both poses exist")
	_host.own_history.undo()
	expect_equal(_lab.poses.from_name, "A", "from, undone")
	_host.own_history.redo()
	expect_equal(_lab.poses.from_name, "start", "from, done again")
	_panel.edits.move("B", 0)
	_panel.edits.rename("B", "finish")
	expect_equal(_lab.poses.to_name, "finish", "to, after it was moved")
	_panel.edits.set_expression("finish", "motor(e1, 1)")
	expect_equal(_message(), "", "message after the next change")


func test_deleted_entries_and_entries_that_are_not_poses() -> void:
	_open({"A": A, "B": B, "C": "rotor(e3, 1)"})
	_lab.choose("A", "B")
	_panel.edits.remove(["B"])
	expect_equal(_message(), "B no longer exists. Choose another entry, or undo.", "message")
	expect_equal(_lab.poses.is_complete(), false, "both poses exist")
	_host.own_history.undo()
	expect_equal(_message(), "", "message after undo")
	expect_true(_lab.poses.is_complete(), "both poses exist again")
	_panel.edits.set_expression("B", "sphere(e1, 2)")
	expect_equal(
		_message(),
		"B is not a motor. Choose a product of translators, rotors and dilators.",
		"message for a sphere"
	)
	_panel.edits.set_expression("B", "meet(A")
	expect_true(
		_message().begins_with("B has no value: column 7: expected ')'"),
		"message for an error: %s" % _message()
	)
	_choose("To", "C")
	expect_equal(_message(), "", "message after another entry was chosen")
	expect_true(_lab.poses.is_complete(), "both poses exist again")
	_panel.edits.remove(["A", "B", "C"])
	expect_true(
		_message().contains("A no longer exists") and _message().contains("C no longer exists"),
		"message without both entries: %s" % _message()
	)
	_panel.document.show_scene(GAScene.new(), "")
	_lab_panel.expand()
	expect_true(
		_message().begins_with("Add two motors"), "message for an empty document: %s" % _message()
	)


func test_an_identity_motor_is_a_pose() -> void:
	_open({"A": "motor(0 e1, rotor(e3, 0), 1)", "B": B})
	expect_equal(_lab.poses.from_name, "A", "from")
	expect_true(_lab.poses.is_complete(), "both poses exist")


func test_settings_are_stored_unless_they_are_defaults() -> void:
	_open({"A": A, "B": B})
	await wait_frames(8)
	var toggle: CheckBox = _lab_panel.find_child("Separate", true, false).find_child(
		"Toggle", true, false
	)
	await _click(toggle)
	expect_equal(_setting("separate"), false, "attribute separate")
	expect_equal(_lab.shows_mode(MultivectorLerp.SEPARATE), false, "separate shown")
	await _click(_lab_panel.find_child("Repeat", true, false) as Button)
	expect_equal(_setting("repeat"), "loop", "attribute repeat")
	var path: CheckBox = _lab_panel.find_child("Path", true, false)
	(_panel.bottom.get_parent() as ScrollContainer).ensure_control_visible(path)
	await wait_frames(8)
	await _click(path)
	expect_equal(_setting("path"), false, "attribute path")
	for i in 3:
		_host.own_history.undo()
	expect_equal(_scene().get_scene_attributes().size(), 0, "number of attributes, undone")
	_lab.set_setting(&"body", "cube")
	_lab.set_setting(&"body", "frame")
	expect_equal(
		_scene().get_scene_attributes().size(), 0, "number of attributes after resetting the body"
	)


func test_invalid_attributes_are_replaced_by_defaults() -> void:
	_open({"A": A, "B": B})
	for attributes: Dictionary in [
		{"t": "x", "body": "ball", "lever_arm": "long", "from": 3.0},
		{"t": -7.0, "ghost_count": 1e9, "duration": 0.0, "t_entry": "A"}
	]:
		for key: String in attributes:
			_scene().set_scene_attribute("interpolation/" + key, attributes[key])
	expect_equal(_lab.t, 0.0, "t, clamped")
	expect_equal(_lab.get_setting(&"ghost_count"), 60.0, "count")
	expect_equal(_lab.get_setting(&"duration"), 0.1, "duration")
	expect_equal(_lab.get_setting(&"body"), "frame", "body")
	expect_equal(_lab.get_setting(&"lever_arm"), 1.0, "lever arm")
	expect_equal(_lab.get_t_entry(), "", "entry of t")
	expect_equal(_lab.poses.from_name, "A", "from")
