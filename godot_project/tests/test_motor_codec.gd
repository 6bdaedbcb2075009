extends "res://tests/framework/test_case.gd"
## MotorCodec: decoded poses are within the tolerances, packets are small, invalid input is an
## error.

const Poses := preload("res://tests/framework/poses.gd")

var _codec := MotorCodec.new()


func test_defaults() -> void:
	expect_near(_codec.position_tolerance, 0.002, 1e-9, "position_tolerance")
	expect_near(_codec.rotation_tolerance, 0.25, 1e-9, "rotation_tolerance")


func test_decoded_poses_are_within_the_tolerances() -> void:
	for tolerance: Vector2 in [Vector2(0.002, 0.25), Vector2(0.0005, 0.05), Vector2(0.02, 1.0)]:
		_codec.position_tolerance = tolerance.x
		_codec.rotation_tolerance = tolerance.y
		var ids := PackedInt32Array()
		var sent: Array[Transform3D] = []
		var generator := RandomNumberGenerator.new()
		generator.seed = 5
		for i in 250:
			ids.append(i * 3)
			sent.append(Poses.random(generator))
		var decoded := _codec.decode(_codec.encode(ids, sent))
		expect_equal(decoded.keys(), ["ids", "transforms"], "keys")
		expect_equal(decoded["ids"], ids, "ids")
		var received: Array[Transform3D] = decoded["transforms"]
		for i in sent.size():
			_expect_close(received[i], sent[i], tolerance)


## Cubes on a field of 40 m.
func test_size_of_a_packet() -> void:
	var generator := RandomNumberGenerator.new()
	generator.seed = 6
	var ids := PackedInt32Array()
	var transforms: Array[Transform3D] = []
	for i in 100:
		ids.append(i)
		var place := Vector3(
			generator.randf_range(-20, 20),
			generator.randf_range(0, 5),
			generator.randf_range(-20, 20)
		)
		transforms.append(Poses.make(place, Poses.random_rotation(generator)))
	var size := _codec.encode(ids, transforms).size()
	expect_true(
		size > 500 and size <= 1100,
		"the size of 100 poses, %d bytes, is between 500 and 1100" % size
	)


func test_degenerate_poses() -> void:
	var ids := PackedInt32Array()
	var sent: Array[Transform3D] = []
	var poses := Poses.degenerate()
	for title: String in poses:
		ids.append(ids.size())
		sent.append(poses[title])
	# At 10 km, single-precision positions are too coarse for the default tolerance of 2 mm.
	_codec.position_tolerance = 0.01
	var received: Array[Transform3D] = _codec.decode(_codec.encode(ids, sent))["transforms"]
	for i in sent.size():
		_expect_close(received[i], sent[i], Vector2(0.012, 0.25))


func test_packet_without_bodies() -> void:
	var decoded := _codec.decode(_codec.encode(PackedInt32Array(), [] as Array[Transform3D]))
	expect_equal(decoded["ids"], PackedInt32Array())
	var transforms: Array = decoded["transforms"]
	expect_equal(transforms.size(), 0)


func test_decoded_array_is_typed() -> void:
	var decoded := _codec.decode(
		_codec.encode(PackedInt32Array([4]), [Transform3D.IDENTITY] as Array[Transform3D])
	)
	var transforms: Array = decoded["transforms"]
	expect_equal(transforms.get_typed_builtin(), int(TYPE_TRANSFORM3D))


func test_invalid_tolerances_change_nothing() -> void:
	expect_error("MotorCodec: position_tolerance is 0, but must be 1e-06 to 1000000 meters.")
	_codec.position_tolerance = 0.0
	for text: String in ["1e+300", "1e-09", "-1e+300", "1e+39", "inf", "nan"]:
		expect_error(
			"MotorCodec: position_tolerance is %s, but must be 1e-06 to 1000000 meters." % text
		)
		_codec.position_tolerance = {"inf": INF, "nan": NAN}.get(text, text.to_float())
	expect_near(_codec.position_tolerance, 0.002, 1e-9)
	expect_error("MotorCodec: rotation_tolerance is -1, but must be 1.7e-05 to 180 degrees.")
	_codec.rotation_tolerance = -1.0
	expect_near(_codec.rotation_tolerance, 0.25, 1e-9)


func test_invalid_input_is_not_encoded() -> void:
	var identity: Array[Transform3D] = [Transform3D.IDENTITY]
	expect_error("MotorCodec.encode: 2 ids but 1 transforms; give one transform for each id.")
	expect_equal(_codec.encode(PackedInt32Array([1, 2]), identity).size(), 0)
	expect_error("MotorCodec.encode: id -3 at index 0 is negative.")
	expect_equal(_codec.encode(PackedInt32Array([-3]), identity).size(), 0)
	var mirrored: Array[Transform3D] = [
		Transform3D(Vector3(-1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3.ZERO)
	]
	expect_error(
		(
			"MotorCodec.encode: the transform at index 0 (id 9) is mirrored (negative scale), "
			+ "which a motor cannot represent; mirror a child node instead."
		)
	)
	expect_equal(_codec.encode(PackedInt32Array([9]), mirrored).size(), 0)


func test_invalid_packets_give_only_an_error() -> void:
	var ids := PackedInt32Array()
	var transforms: Array[Transform3D] = []
	for i in 20:
		ids.append(i)
		transforms.append(Poses.make(Vector3(i, 1, -i)))
	var packet := _codec.encode(ids, transforms)
	for size in packet.size():
		var decoded := _codec.decode(packet.slice(0, size))
		expect_equal(decoded.keys(), ["error"], "keys of a packet truncated to %d bytes" % size)
	var longer := packet.duplicate()
	longer.append(0)
	expect_equal(
		_codec.decode(longer).keys(), ["error"], "keys of a packet with an additional byte"
	)


func test_damaged_packets_never_give_invalid_poses() -> void:
	var generator := RandomNumberGenerator.new()
	generator.seed = 11
	var packet := _codec.encode(
		PackedInt32Array([1, 2]),
		[Transform3D.IDENTITY, Poses.make(Vector3(1, 2, 3))] as Array[Transform3D]
	)
	for i in 2000:
		var damaged := packet.duplicate()
		damaged[generator.randi_range(0, damaged.size() - 1)] = generator.randi_range(0, 255)
		var decoded := _codec.decode(damaged)
		if decoded.has("error"):
			continue
		var received: Array[Transform3D] = decoded["transforms"]
		for pose in received:
			expect_true(pose.is_finite(), "poses of damaged packet %d are finite" % i)


func _expect_close(received: Transform3D, sent: Transform3D, tolerance: Vector2) -> void:
	expect_vector_near(received.origin, sent.origin, tolerance.x, "position")
	var rotation := (
		received.basis.get_rotation_quaternion().inverse() * sent.basis.get_rotation_quaternion()
	)
	var angle := 2.0 * atan2(Vector3(rotation.x, rotation.y, rotation.z).length(), absf(rotation.w))
	expect_near(rad_to_deg(angle), 0.0, tolerance.y + 1e-3, "angle in degrees")
	expect_near(
		received.basis.get_scale().x / sent.basis.get_scale().x, 1.0, 2e-4, "ratio of scales"
	)
