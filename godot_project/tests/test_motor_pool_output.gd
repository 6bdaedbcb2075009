extends "res://tests/framework/test_case.gd"
## MotorPool applies its poses to nodes and to a MultiMesh.

const Poses := preload("res://tests/framework/poses.gd")
const COUNT := 10

var _pool := MotorPool.new()
var _poses: Array[Transform3D] = []


func test_nodes_are_moved() -> void:
	_fill()
	var nodes := _make_nodes()
	_pool.apply_to_nodes(nodes)
	for i in COUNT:
		expect_transform_near(nodes[i].transform, _poses[i], 1e-5, "node %d" % i)


func test_a_freed_or_null_node_moves_no_node() -> void:
	_fill()
	var nodes := _make_nodes()
	nodes[4].free()
	expect_error(
		"MotorPool.apply_to_nodes: the node at index 4 is null or freed. No node was moved."
	)
	_pool.apply_to_nodes(nodes)
	nodes[4] = null
	expect_error(
		"MotorPool.apply_to_nodes: the node at index 4 is null or freed. No node was moved."
	)
	_pool.apply_to_nodes(nodes)
	expect_equal(nodes[0].transform, Transform3D.IDENTITY)
	nodes.remove_at(4)
	expect_error(
		(
			"MotorPool.apply_to_nodes: got 9 nodes for 10 bodies; pass one per body, in "
			+ "the order of acquire()."
		)
	)
	_pool.apply_to_nodes(nodes)
	expect_equal(nodes[0].transform, Transform3D.IDENTITY)


func test_a_multimesh_gets_the_buffer() -> void:
	_fill()
	var multimesh := _make_multimesh(COUNT)
	_pool.apply_to_multimesh(multimesh)
	# The headless renderer stores the buffer, but no single instances.
	expect_equal(multimesh.buffer, _pool.get_buffer())
	for i in COUNT:
		expect_near(multimesh.buffer[12 * i + 3], _poses[i].origin.x, 1e-5, "x of instance %d" % i)


func test_surplus_instances_draw_nothing() -> void:
	_fill()
	var multimesh := _make_multimesh(COUNT + 3)
	_pool.apply_to_multimesh(multimesh)
	var buffer := multimesh.buffer
	expect_equal(buffer.size(), 12 * (COUNT + 3), "size of the buffer")
	expect_equal(buffer.slice(0, 12 * COUNT), _pool.get_buffer(), "the bodies' part")
	for i in range(12 * COUNT, buffer.size()):
		expect_equal(buffer[i], 0.0, "float %d" % i)


func test_an_unsuitable_multimesh_is_an_error() -> void:
	_fill()
	expect_error("MotorPool.apply_to_multimesh: the multimesh is null.")
	_pool.apply_to_multimesh(null)
	expect_error(
		(
			"MotorPool.apply_to_multimesh: instance_count is 9, less than the 10 bodies; "
			+ "set it to at least that number."
		)
	)
	_pool.apply_to_multimesh(_make_multimesh(COUNT - 1))
	var flat := MultiMesh.new()
	flat.instance_count = COUNT
	expect_error(
		(
			"MotorPool.apply_to_multimesh: set the multimesh's transform_format to "
			+ "TRANSFORM_3D, before its instance_count."
		)
	)
	_pool.apply_to_multimesh(flat)
	expect_equal(_pool.get_count(), COUNT)


## The headless renderer returns the last buffer that it was given.
func test_instance_data_is_uploaded() -> void:
	_fill()
	var multimesh := MultiMesh.new()
	multimesh.transform_format = MultiMesh.TRANSFORM_3D
	multimesh.use_colors = true
	multimesh.instance_count = COUNT + 1
	var colors := PackedFloat32Array()
	for i in 4 * (COUNT + 1):
		colors.append(i / 64.0)
	_pool.apply_to_multimesh(multimesh, colors)
	var buffer := multimesh.buffer
	expect_equal(buffer.size(), 16 * (COUNT + 1), "size of the buffer")
	for i in COUNT + 1:
		expect_equal(
			buffer.slice(16 * i + 12, 16 * i + 16), colors.slice(4 * i, 4 * i + 4), "color %d" % i
		)
	for i in COUNT:
		expect_equal(
			buffer.slice(16 * i, 16 * i + 12),
			_pool.get_buffer().slice(12 * i, 12 * i + 12),
			"row %d" % i
		)
	expect_equal(buffer[16 * COUNT + 3], 0.0, "x of the surplus instance")
	expect_error(
		(
			"MotorPool.apply_to_multimesh: instance_data has 3 floats, but 11 instances "
			+ "with 4 floats each (4 for color, 4 for custom data) need 44."
		)
	)
	_pool.apply_to_multimesh(multimesh, PackedFloat32Array([1, 2, 3]))


func test_other_nodes_in_the_next_frame() -> void:
	_fill()
	var first := _make_nodes()
	_pool.apply_to_nodes(first)
	var second := _make_nodes()
	second[3] = first[4]
	_pool.interpolate(1.0, MultivectorLerp.LINEAR)
	first[3].transform = Transform3D.IDENTITY
	_pool.apply_to_nodes(second)
	expect_transform_near(second[3].transform, _poses[3], 1e-5, "the node at another index")
	expect_equal(first[3].transform, Transform3D.IDENTITY, "the node that was left out")
	first[4].free()
	expect_error(
		"MotorPool.apply_to_nodes: the node at index 3 is null or freed. No node was moved."
	)
	_pool.apply_to_nodes(second)


func _fill() -> void:
	var generator := RandomNumberGenerator.new()
	generator.seed = 3
	for i in COUNT:
		_poses.append(Poses.random(generator))
		_pool.acquire()
	_pool.set_from_all(_poses)
	_pool.set_to_all(_poses)
	_pool.interpolate(0.0, MultivectorLerp.LINEAR)


func _make_nodes() -> Array[Node3D]:
	var nodes: Array[Node3D] = []
	for i in COUNT:
		nodes.append(Node3D.new())
		add_node(nodes[i])
	return nodes


func _make_multimesh(count: int) -> MultiMesh:
	var multimesh := MultiMesh.new()
	multimesh.transform_format = MultiMesh.TRANSFORM_3D
	multimesh.instance_count = count
	return multimesh
