extends "res://tests/framework/test_case.gd"
## Handlers of signals free and change the GAScene, GANode3D and MotorReceiver that emit them.

const BODIES := 50

var _scene := GAScene.new()
var _receiver := MotorReceiver.new()
var _node := GANode3D.new()


func test_a_handler_of_entries_changed_releases_the_scene() -> void:
	_free_unused()
	var changed: Array[bool] = [false]
	_scene.changed.connect(func() -> void: changed[0] = true)
	_scene.entries_changed.connect(
		func(_names: PackedStringArray) -> void:
			_scene = null
			# Others reuse the memory.
			for i in 100:
				GAScene.new().add_entry("a", "e1")
	)
	_scene.add_entry("a", "e1")
	expect_null(_scene, "the scene")
	expect_true(changed[0], "changed was emitted")


func test_a_handler_of_entries_changed_loads_another_document() -> void:
	_free_unused()
	_scene.entries_changed.connect(
		func(_names: PackedStringArray) -> void: _scene.load_json('{"entries": []}'),
		CONNECT_ONE_SHOT
	)
	expect_error(
		(
			"GAScene.load_json: parts of the text could not be read; the rest was loaded:\n"
			+ "column 49: entry 'b' skipped: an earlier entry has the same name."
		)
	)
	var error := _scene.load_json(
		'{"entries": [{"name": "b", "expression": "e1"}, {"name": "b", "expression": "e2"}]}'
	)
	expect_equal(error, ERR_FILE_CORRUPT, "error of the outer document")


func test_a_handler_of_body_added_advances() -> void:
	_free_unused()
	var sender := _make_sender(0)
	_feed(sender, 0.0)
	var added := PackedInt32Array()
	_receiver.body_added.connect(
		func(id: int) -> void:
			added.append(id)
			if id == 0:
				_add_bodies(sender, BODIES, 4 * BODIES)
				_feed(sender, 1.0)
				_receiver.advance(3.0)
	)
	_receiver.advance(0.5)
	expect_equal(added, PackedInt32Array(range(5 * BODIES)), "bodies in their order")


func test_a_handler_of_body_added_clears_the_receiver() -> void:
	_free_unused()
	_feed(_make_sender(0), 0.0)
	var added := PackedInt32Array()
	_receiver.body_added.connect(
		func(id: int) -> void:
			added.append(id)
			_receiver.clear()
			_receiver.advance(0.6)
	)
	_receiver.advance(0.5)
	expect_equal(added, PackedInt32Array([0]), "added bodies")
	_feed(_make_sender(1), 1.0)
	_receiver.advance(1.5)
	expect_equal(added, PackedInt32Array([0, 0]), "added bodies of the next stream")


func test_a_handler_of_body_added_releases_the_receiver() -> void:
	_free_unused()
	_feed(_make_sender(0), 0.0)
	var added := PackedInt32Array()
	_receiver.body_added.connect(
		func(id: int) -> void:
			added.append(id)
			_receiver = null
			for i in 20:
				MotorReceiver.new().advance(0.0)
	)
	_receiver.advance(0.5)
	expect_equal(added.size(), BODIES, "added bodies")


func test_a_handler_frees_the_label() -> void:
	_make_labeled()
	var label := _node.get_child(0, true)
	label.free()
	_node.label = "new"
	expect_equal(_node.get_child_count(true), 1, "labels")
	for i in 3:
		(_node.get_child(0, true) as Node3D).visibility_changed.connect(
			func() -> void: _node.get_child(0, true).queue_free()
		)
		_node.show_label = false
		_node.show_label = true
		await wait_frames(2)
		_node.label = "new %d" % i
		expect_equal(_node.get_child_count(true), 1, "labels")


func test_a_handler_frees_the_new_label_and_its_node() -> void:
	_free_unused()
	_node = GANode3D.new()
	_node.multivector = Multivector.point(Vector3.ZERO)
	_node.show_label = true
	_node.child_entered_tree.connect(func(label: Node) -> void: label.queue_free())
	add_node(_node)
	await wait_frames(3)
	expect_equal(_node.get_child_count(true), 0, "labels")
	_node.label = "new"
	await wait_frames(3)
	_node.label = "newer"
	expect_equal(_node.get_child_count(true), 1, "labels")


func free_nodes() -> void:
	super()
	_free_unused()
	# Their handlers keep this test alive.
	_scene = null
	_receiver = null


func _free_unused() -> void:
	if is_instance_valid(_node):
		_node.free()


func _make_labeled() -> void:
	_node.multivector = Multivector.point(Vector3.ZERO)
	_node.show_label = true
	add_node(_node)
	_node.update_drawing()
	expect_equal(_node.get_child_count(true), 1, "labels")


func _make_sender(time: float) -> MotorSender:
	var sender := MotorSender.new()
	_add_bodies(sender, 0, BODIES)
	sender.add_receiver(1, time)
	return sender


func _add_bodies(sender: MotorSender, first: int, count: int) -> void:
	for i in range(first, first + count):
		sender.add_body(i, Transform3D(Basis.IDENTITY, Vector3(i, 0, 0)))


## Gives the receiver what the sender sends in a third of a second from [param time] on.
func _feed(sender: MotorSender, time: float) -> void:
	for tick in 20:
		var now := time + tick / 60.0
		for i in sender.get_body_count():
			sender.observe(i, now, Transform3D(Basis.IDENTITY, Vector3(i, tick, 0)))
		for packet in sender.flush(now):
			_receiver.accept(packet["bytes"] as PackedByteArray, now)
