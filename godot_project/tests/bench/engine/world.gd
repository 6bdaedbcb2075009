extends Node3D
## The scene of the benchmark: cubes, their two poses, and the time of processing a frame.

const SPACING := 3.0

var nodes: Array[Node3D] = []
var from: Array[Transform3D] = []
var to: Array[Transform3D] = []
## The weight of interpolation in this frame.
var weight := 0.0
## When processing of this frame began and how long it took, in microseconds.
var began := 0
var work := 0

var multimesh_instance := MultiMeshInstance3D.new()
var cubes := Node3D.new()


## Signals the start or end of processing in a frame, depending on its priority.
class Clock:
	extends Node

	signal struck

	func _init(priority: int) -> void:
		process_priority = priority

	func _process(_delta: float) -> void:
		struck.emit()


func _init(count: int) -> void:
	var random := RandomNumberGenerator.new()
	random.seed = 2026
	var mesh := BoxMesh.new()
	var side := ceili(pow(count, 1.0 / 3.0))
	for i in count:
		var cube := MeshInstance3D.new()
		cube.mesh = mesh
		cubes.add_child(cube)
		nodes.append(cube)
		var place := (
			Vector3(i % side, i / side % side, i / side / side) - Vector3.ONE * (side / 2.0)
		)
		from.append(_random_pose(random, place * SPACING))
		to.append(_random_pose(random, place * SPACING))
		cube.transform = from[i]
	add_child(cubes)
	multimesh_instance.multimesh = MultiMesh.new()
	multimesh_instance.multimesh.transform_format = MultiMesh.TRANSFORM_3D
	multimesh_instance.multimesh.mesh = mesh
	multimesh_instance.multimesh.instance_count = count
	add_child(multimesh_instance)
	show_multimesh(false)
	var camera := Camera3D.new()
	camera.position = Vector3(0, 0, side * SPACING * 1.5)
	add_child(camera)
	add_child(DirectionalLight3D.new())
	_add_clock(-1000, _begin)
	_add_clock(1000, _end)


func show_multimesh(shown: bool) -> void:
	multimesh_instance.visible = shown
	cubes.visible = not shown


func _add_clock(priority: int, strike: Callable) -> void:
	var clock := Clock.new(priority)
	clock.struck.connect(strike)
	add_child(clock)


func _begin() -> void:
	weight = fmod(weight + 0.037, 1.0)
	began = Time.get_ticks_usec()


func _end() -> void:
	work = Time.get_ticks_usec() - began


func _random_pose(random: RandomNumberGenerator, place: Vector3) -> Transform3D:
	var rotation_now := (
		Quaternion(random.randfn(), random.randfn(), random.randfn(), random.randfn()).normalized()
	)
	return Transform3D(
		Basis(rotation_now), place + Vector3(random.randf(), random.randf(), random.randf())
	)
