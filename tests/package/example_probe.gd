extends SceneTree
## Runs the examples of the addon and checks what they show; ends with exit code 0 only if they do.

const FOLDER := "res://addons/ga_godot/examples"
const SECONDS := 4.0
const TOLERANCE := 0.006

var _failed := false


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	Engine.max_fps = 60
	var examples := DirAccess.get_files_at(FOLDER)
	_expect(examples.has("replication.tscn") and examples.has("geometry.tscn"), "two examples")
	await _replication()
	await _geometry()
	quit(1 if _failed else 0)


func _replication() -> void:
	var example := _open("replication.tscn")
	await create_timer(SECONDS).timeout
	var shown: Node3D = example.get_node("Client/Cube0")
	_expect(shown.position.length() > 1.0, "the client's cubes are where the server's are")
	var error: float = example.call("get_error")
	_expect(error < TOLERANCE, "an error of %f m, at most %f" % [error, TOLERANCE])
	_report(example)


func _geometry() -> void:
	var example := _open("geometry.tscn")
	var ring: GANode3D = example.get_node("Ring")
	var door: Node3D = example.get_node("Door")
	var kinds: Dictionary = {}
	var angles := PackedFloat64Array()
	for frame in 400:
		await process_frame
		kinds[ring.describe().get_slice(",", 0)] = true
		angles.append(door.rotation.y)
	_expect(kinds.has("circle") and kinds.has("imaginary circle"), "kinds of ring: %s" % kinds)
	angles.sort()
	var opened := rad_to_deg(angles[-1] - angles[0])
	_expect(absf(opened - 100.0) < 0.5, "the door opens by %f degrees" % opened)
	_report(example)


func _open(file: String) -> Node:
	var scene: PackedScene = load(FOLDER.path_join(file))
	var example := scene.instantiate()
	root.add_child(example)
	return example


func _report(example: Node) -> void:
	var label: Label = example.get_node("Label")
	print("example: %s: %s" % [example.name, label.text])
	example.free()


func _expect(condition: bool, what: String) -> void:
	if not condition:
		_failed = true
		printerr("FAIL: %s" % what)
