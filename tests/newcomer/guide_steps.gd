extends SceneTree
## Takes the steps of the guides in the newcomer's project, headless. Ends with exit code 0 only if
## everything is as the guides say. The user arguments are the pages whose samples are run.

const CodeSample := preload("res://code_sample.gd")
const EXPRESSIONS := "res://addons/ga_godot/docs/guides/expressions.md"

var _failed := false


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	_networking()
	await _interpolation()
	await _playground()
	_expressions()
	_samples()
	quit(1 if _failed else 0)


## Steps 2 to 4 of the guide; the result is what the guide has as text.
func _networking() -> void:
	var main := Node3D.new()
	main.name = "Main"
	var cube := MeshInstance3D.new()
	cube.name = "Cube"
	cube.mesh = BoxMesh.new()
	_add(main, cube)
	var camera := Camera3D.new()
	camera.position = Vector3(0, 1, 6)
	_add(main, camera, "Camera3D")
	var light := DirectionalLight3D.new()
	light.rotation_degrees = Vector3(-60, 30, 0)
	_add(main, light, "DirectionalLight3D")
	var synchronizer := MotorSynchronizer.new()
	_add(main, synchronizer, "MotorSynchronizer")
	synchronizer.targets = [^"../Cube"]
	_expect(synchronizer.get_setup_warnings().is_empty(), "no warnings about the setup")
	main.set_script(load("res://main.gd"))
	var packed := PackedScene.new()
	packed.pack(main)
	_expect(ResourceSaver.save(packed, "res://main.tscn") == OK, "saving the scene")
	main.free()
	var text: PackedScene = load("res://as_text.tscn")
	var as_text := _describe(text)
	_expect(_describe(packed) == as_text, "%s, as text %s" % [_describe(packed), as_text])
	print("guide: networking: %d nodes" % as_text.size())


## A line for each node with its properties, except that numbers are rounded.
func _describe(scene: PackedScene) -> PackedStringArray:
	var state := scene.get_state()
	var lines := PackedStringArray()
	for node in state.get_node_count():
		var words := PackedStringArray([state.get_node_path(node), state.get_node_type(node)])
		for property in state.get_node_property_count(node):
			var value: Variant = state.get_node_property_value(node, property)
			if value is Transform3D:
				var pose: Transform3D = value
				value = "%s %s" % [pose.basis.get_euler().snappedf(0.001), pose.origin]
			elif value is Script:
				value = (value as Script).resource_path
			elif value is Resource:
				value = (value as Resource).get_class()
			words.append("%s = %s" % [state.get_node_property_name(node, property), value])
		lines.append(", ".join(words))
	return lines


## "As a node": three nodes, a mode, auto_play.
func _interpolation() -> void:
	var world := Node3D.new()
	root.add_child(world)
	for title: String in ["Start", "End", "Target"]:
		var node := Node3D.new()
		node.name = title
		world.add_child(node)
	var start: Node3D = world.get_node(^"Start")
	var end: Node3D = world.get_node(^"End")
	var target: Node3D = world.get_node(^"Target")
	start.position = Vector3(1, 0, 0)
	end.position = Vector3(0, 0, -1)
	end.rotation_degrees = Vector3(0, 90, 0)
	var motion := MultivectorLerp.new()
	motion.start = ^"../Start"
	motion.end = ^"../End"
	motion.target = ^"../Target"
	motion.mode = MultivectorLerp.SCREW
	motion.factor = 0.5
	world.add_child(motion)
	for frame in 3:
		await process_frame
	_expect(
		absf(target.position.length() - 1.0) < 1e-4, "halfway on the circle: %s" % target.position
	)
	_expect(absf(target.rotation_degrees.y - 45.0) < 0.01, "half the rotation")
	motion.duration = 0.2
	motion.auto_play = true
	motion.factor = 0.0
	motion.play()
	var deadline := Time.get_ticks_msec() + 10000
	while target.position.distance_to(end.position) > 1e-4 and Time.get_ticks_msec() < deadline:
		await process_frame
		_expect(absf(target.position.length() - 1.0) < 1e-4, "on the circle: %s" % target.position)
	_expect(target.position.distance_to(end.position) < 1e-4, "the end: %s" % target.position)
	print("guide: interpolation: along the screw path to %s" % target.position)
	world.free()


## "In the editor and in your game": a node draws an entry that a script changes.
func _playground() -> void:
	var scene := GAScene.new()
	scene.add_entry("ball", "sphere(0, 1, 0, 1)")
	scene.add_entry("height", "0.5")
	scene.add_entry("ring", "meet(ball, plane(e2, height))")
	var node := GANode3D.new()
	node.scene = scene
	node.entry = &"ring"
	root.add_child(node)
	await process_frame
	var before := node.describe()
	scene.set_parameter("height", "value", 1.0)
	await process_frame
	_expect(before.begins_with("circle, radius 0.866"), before)
	_expect(node.describe().begins_with("circle, radius 1, center (0, 1, 0)"), node.describe())
	print("guide: playground: %s" % node.describe())
	node.free()


## Both sides of each equation in the examples have the same value.
func _expressions() -> void:
	var count := 0
	var text := FileAccess.get_file_as_string(EXPRESSIONS)
	for part in text.split("```expressions\n").slice(1):
		for line in part.get_slice("```", 0).strip_edges().split("\n"):
			if line.contains(" error: "):
				continue
			var sides := line.split(" = ")
			var left := Multivector.evaluate(sides[0])
			var right := Multivector.evaluate(sides[1])
			_expect(left.is_equal_approx(right), line)
			count += 1
	_expect(count > 35, "%d equations" % count)
	print("guide: expressions: %d equations" % count)


## The samples of the pages, with the settings of a new project.
func _samples() -> void:
	var count := 0
	var parent := Node3D.new()
	parent.name = "Samples"
	root.add_child(parent)
	for page in OS.get_cmdline_user_args():
		for sample in CodeSample.samples_of_page(FileAccess.get_file_as_string(page)):
			count += 1
			var faults := CodeSample.find_faults(sample, parent)
			_expect(faults.is_empty(), "%s: %s" % [page, "\n".join(faults)])
	parent.free()
	_expect(count >= 10, "%d samples" % count)
	print("guide: samples: %d" % count)


func _add(main: Node3D, node: Node, title := "") -> void:
	if not title.is_empty():
		node.name = title
	main.add_child(node)
	node.owner = main


func _expect(condition: bool, what: String) -> void:
	if not condition:
		_failed = true
		printerr("ERROR: %s" % what)
