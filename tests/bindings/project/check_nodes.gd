## Nodes: virtual methods, notifications, signals, access to the scene tree from C++.
extends Checks


func check_virtual_methods_and_notifications() -> void:
	var node := SampleNode.new()
	same(node.get_log(), PackedStringArray(["postinitialize"]))
	tree.root.add_child(node)
	same(node.get_log(), PackedStringArray(["postinitialize", "enter", "ready"]))
	await tree.process_frame
	await tree.process_frame
	same(node.get_frames() >= 1, true)
	tree.root.remove_child(node)
	same(node.get_log()[-1], "exit")
	node.free()


func check_order_below_another_extension_class() -> void:
	var node := SampleChild.new()
	tree.root.add_child(node)
	tree.root.remove_child(node)
	# The parent class is notified first, and last when the node leaves the tree.
	same(
		node.get_log(),
		PackedStringArray(["postinitialize", "enter", "child enter", "ready", "child exit", "exit"])
	)
	tree.root.add_child(node)
	await tree.process_frame
	await tree.process_frame
	same(node.get_frames() >= 1, true)
	same(node.get_time() > 0.0, true)
	same(node is SampleNode, true)
	same(node.get_class(), "SampleChild")
	node.free()


func check_signals() -> void:
	var node := SampleNode.new()
	node.name = "Sender"
	var heard: Array = []
	node.stepped.connect(func(frame: int, who: StringName) -> void: heard.append([frame, who]))
	tree.root.add_child(node)
	await tree.process_frame
	await tree.process_frame
	same(heard[0], [1, &"Sender"])
	var arguments: Array = []
	for entry: Dictionary in ClassDB.class_get_signal("SampleNode", "stepped")["args"]:
		arguments.append([entry["name"], entry["type"]])
	same(arguments, [["frame", TYPE_INT], ["who", TYPE_STRING_NAME]])
	node.free()


func check_finding_nodes() -> void:
	var node := SampleNode.new()
	var mark := Marker3D.new()
	mark.name = "Mark"
	var timer := Timer.new()
	timer.name = "Timer"
	node.add_child(mark)
	node.add_child(timer)
	tree.root.add_child(node)
	same(node.find_missing(), "missing")
	node.target = ^"Mark"
	same(node.find_target(), "Mark")
	node.target = ^"Timer"
	same(node.find_target(), "none")
	node.free()


func check_nodes_that_cpp_makes() -> void:
	var node := SampleNode.new()
	tree.root.add_child(node)
	var child: SampleMover = node.grow("Sprout")
	same(child.name, &"Sprout")
	same(child.get_parent(), node)
	var label := Timer.new()
	node.add_child(label)
	same(node.prune(), 2)
	same(node.get_child_count(), 0)
	same(is_instance_valid(child) or is_instance_valid(label), false)
	child = node.grow("Late")
	node.free()
	same(is_instance_valid(child), false)


func check_calls_by_name() -> void:
	var node := SampleNode.new()
	same(
		node.call_other(SampleValues.new(), &"combine", Vector3.RIGHT, Vector3.UP),
		Vector3(-2, 2, 0)
	)
	same(node.call_other(node, &"set_meta", &"key", [1]), null)
	same(node.get_meta(&"key"), [1])
	same(node.call_other(null, &"any", 1, 2), null)
	node.free()


func check_transforms() -> void:
	var parent := Node3D.new()
	parent.position = Vector3(10, 0, 0)
	var mover := SampleMover.new()
	mover.scale = Vector3(2, 2, 2)
	parent.add_child(mover)
	tree.root.add_child(parent)
	mover.place(Vector3(1, 2, 3))
	same(mover.transform, Transform3D(Basis.from_scale(Vector3(2, 2, 2)), Vector3(1, 2, 3)))
	same(mover.global_position, Vector3(11, 2, 3))
	same(mover.parent_position(), Vector3(10, 0, 0))
	mover.place_other(mover, Transform3D.IDENTITY)
	same(mover.position, Vector3(-10, 0, 0))
	mover.place_other(null, Transform3D.IDENTITY)
	parent.free()


func check_2d_nodes() -> void:
	var parent := Node2D.new()
	parent.position = Vector2(10, 0)
	var mark := Marker2D.new()
	parent.add_child(mark)
	tree.root.add_child(parent)
	var mover := SampleMover.new()
	same(
		mover.place_flat(mark, Vector2(1, 2), 0.5, Vector2(2, 3), false),
		[Vector2(1, 2), 0.5, Vector2(2, 3), Vector2(11, 2), false]
	)
	same([mark.position, mark.rotation, mark.visible], [Vector2(1, 2), 0.5, false])
	same(mark.scale, Vector2(2, 3))
	same(mover.place_flat(mover, Vector2.ZERO, 0.0, Vector2.ONE, true), [])
	same(mover.place_flat(null, Vector2.ZERO, 0.0, Vector2.ONE, true), [])
	mover.free()
	parent.free()


func check_scripts_of_nodes() -> void:
	var script := GDScript.new()
	script.source_code = "extends SampleChild\nvar seen := 0\nfunc _ready() -> void:\n\tseen += 1\n"
	same(script.reload(), OK)
	var node: SampleChild = script.new()
	tree.root.add_child(node)
	same(node.get("seen"), 1)
	# The script's _ready replaces that of the class.
	same(node.get_log(), PackedStringArray(["postinitialize", "enter", "child enter"]))
	node.free()
