extends "res://tests/framework/test_case.gd"
## The examples of replication without Godot's multiplayer: over a UDP socket, and to a file.

const MotionPlayer := preload("res://demos/recording/motion_player.gd")
const MotionRecorder := preload("res://demos/recording/motion_recorder.gd")
const RawUdp := preload("res://demos/raw_udp/raw_udp.gd")
const Recording := preload("res://demos/recording/recording.gd")
const CookieHandshake := preload("res://demos/raw_udp/cookie_handshake.gd")
const StreamServer := preload("res://demos/raw_udp/stream_server.gd")

const PATH := "user://test.gamotion"
const RATE := 60


func test_motion_arrives_over_a_socket() -> void:
	var example: RawUdp = (load("res://demos/raw_udp/raw_udp.tscn") as PackedScene).instantiate()
	tree.root.add_child(example)
	await tree.create_timer(1.2).timeout
	expect_true(example.receiver.has_body(RawUdp.BODY), "the receiver has the body")
	var media_time := example.receiver.get_media_time()
	expect_true(media_time > 0.5, "the media time of %.2f s is above 0.5 s" % media_time)
	# The stream began at the first tick.
	var truth := example.get_pose(media_time + 1.0 / Engine.physics_ticks_per_second)
	var shown := example.receiver.get_transform(RawUdp.BODY)
	expect_true(
		shown.origin.distance_to(truth.origin) < 0.04,
		"the error of %.1f mm is below 40 mm" % (1000.0 * shown.origin.distance_to(truth.origin))
	)
	var bytes: int = example.sender.get_statistics(RawUdp.RECEIVER).bytes_sent
	expect_true(bytes < 400, "%d bytes in 1.2 s are fewer than 400" % bytes)
	var rejected: int = example.receiver.get_statistics().packets_rejected
	expect_equal(rejected, 0, "rejected packets")
	example.free()


## An attacker sends all kinds of packets from an address at which it does not receive: the server
## replies only with cookies, which are shorter than the packets.
func test_a_forged_address_gets_no_stream() -> void:
	var server := StreamServer.new()
	server.listen(RawUdp.ADDRESS)
	for body in 200:
		server.sender.add_body(body, Transform3D.IDENTITY.translated(Vector3(body, 0.0, 0.0)))
	var victim := PacketPeerUDP.new()
	victim.bind(0, RawUdp.ADDRESS)
	victim.set_dest_address(RawUdp.ADDRESS, server.get_port())
	var random := RandomNumberGenerator.new()
	random.seed = 3
	var join := PackedByteArray([CookieHandshake.Kind.JOIN])
	join.resize(1 + CookieHandshake.COOKIE_SIZE)
	var packets: Array[PackedByteArray] = [CookieHandshake.make_hello(), join]
	for size: int in [1, 2, 17, 40, 64, 65, 300]:
		for kind: int in [0, 1, 2, 3, 255]:
			var packet := PackedByteArray()
			for i: int in size:
				packet.append(random.randi() & 255)
			packet[0] = kind
			packets.append(packet)
	var sent := 0
	for packet in packets:
		victim.put_packet(packet)
		sent += packet.size()
	var received := await _bytes_received(server, victim, packets.size())
	expect_equal(server.get_client_count(), 0, "clients")
	expect_true(received > 0, "the server replies to a hello")
	expect_true(received <= sent, "%d bytes for %d sent are not more" % [received, sent])
	for packet in packets:
		victim.put_packet(packet)
		received = await _bytes_received(server, victim, 1)
		expect_true(
			received <= packet.size(), "%d bytes for %d are not more" % [received, packet.size()]
		)


func test_a_cookie_is_valid_for_its_address_and_time() -> void:
	var handshake := CookieHandshake.new()
	var hello := CookieHandshake.make_hello()
	var cookie := handshake.make_cookie(hello, "10.0.0.1", 4000, 100.0)
	expect_equal(cookie.size(), 1 + CookieHandshake.COOKIE_SIZE, "size of the cookie")
	var join := CookieHandshake.make_join(cookie)
	for age: float in [0.0, 5.0, 9.9]:
		expect_true(handshake.is_join(join, "10.0.0.1", 4000, 100.0 + age), "age %.1f s" % age)
	for age: float in [-20.0, 20.0, 1e6]:
		expect_true(not handshake.is_join(join, "10.0.0.1", 4000, 100.0 + age), "age %.1f s" % age)
	expect_true(not handshake.is_join(join, "10.0.0.2", 4000, 100.0), "another address")
	expect_true(not handshake.is_join(join, "10.0.0.1", 4001, 100.0), "another port")
	expect_true(not CookieHandshake.new().is_join(join, "10.0.0.1", 4000, 100.0), "another server")
	for i in join.size():
		var damaged := join.duplicate()
		damaged[i] ^= 1
		expect_true(not handshake.is_join(damaged, "10.0.0.1", 4000, 100.0), "bit of byte %d" % i)
	expect_true(
		handshake.make_cookie(hello.slice(0, 20), "10.0.0.1", 4000, 100.0).is_empty(), "short hello"
	)


func test_recording_plays_within_the_tolerance() -> void:
	var recorder := MotionRecorder.new()
	expect_equal(recorder.open(PATH, Recording.get_poses(0.0)), OK, "opening for writing")
	for tick in 2 * RATE:
		recorder.record(float(tick) / RATE, Recording.get_poses(float(tick) / RATE))
	var size := recorder.close()
	expect_true(size < 64 * 2 * 80, "%d bytes for 64 bodies and 2 s are fewer than 10240" % size)
	var player := MotionPlayer.new()
	expect_equal(player.open(PATH), OK, "opening for reading")
	var worst := 0.0
	for frame in 3 * RATE:
		player.play(float(frame) / RATE)
		var media_time := player.receiver.get_media_time()
		# The recording begins with a snapshot at its first ticks.
		if media_time <= 0.1 or media_time > 2.0 - 1.0 / RATE:
			continue
		var truth := Recording.get_poses(media_time)
		for id in Recording.COUNT:
			worst = maxf(
				worst, player.receiver.get_transform(id).origin.distance_to(truth[id].origin)
			)
	expect_true(
		player.receiver.get_media_time() > 1.5,
		"the recording played up to %.2f s, beyond 1.5 s" % player.receiver.get_media_time()
	)
	expect_true(worst < 0.0055, "the maximum error of %.1f mm is below 5.5 mm" % (1000.0 * worst))
	DirAccess.remove_absolute(ProjectSettings.globalize_path(PATH))


func test_a_recording_that_was_cut_short_plays_up_to_there() -> void:
	var recorder := MotionRecorder.new()
	recorder.open(PATH, Recording.get_poses(0.0))
	for tick in RATE:
		recorder.record(float(tick) / RATE, Recording.get_poses(float(tick) / RATE))
	var size := recorder.close()
	var bytes := FileAccess.get_file_as_bytes(PATH)
	expect_equal(bytes.size(), size, "bytes")
	for cut: int in [size - 1, size / 2, MotionRecorder.MAGIC.length() + 3]:
		var file := FileAccess.open(PATH, FileAccess.WRITE)
		file.store_buffer(bytes.slice(0, cut))
		file.close()
		var player := MotionPlayer.new()
		expect_equal(player.open(PATH), OK, "opening %d of %d bytes" % [cut, size])
		player.play(2.0)
		expect_true(player.is_over(), "the recording is over")
		expect_equal(player.receiver.get_statistics().packets_rejected, 0, "rejected packets")
	DirAccess.remove_absolute(ProjectSettings.globalize_path(PATH))


func test_other_files_are_rejected() -> void:
	var file := FileAccess.open(PATH, FileAccess.WRITE)
	file.store_string("GAPOSES1 something else")
	file.close()
	expect_equal(MotionPlayer.new().open(PATH), ERR_FILE_UNRECOGNIZED, "error for another file")
	DirAccess.remove_absolute(ProjectSettings.globalize_path(PATH))
	expect_equal(MotionPlayer.new().open(PATH), ERR_FILE_NOT_FOUND, "error without a file")


func test_the_recording_scene_plays() -> void:
	var example := (load("res://demos/recording/recording.tscn") as PackedScene).instantiate()
	tree.root.add_child(example)
	await tree.create_timer(0.5).timeout
	var text: String = (example.get_node(^"Label") as Label).text
	expect_true(text.begins_with("64 cubes, 4 s: "), text)
	example.free()


## Updates the server until it has had time for [param count] packets; returns what came back.
func _bytes_received(server: StreamServer, victim: PacketPeerUDP, count: int) -> int:
	var received := 0
	for tick in 3 + count / 10:
		server.update(tick / 60.0, 100.0)
		await tree.physics_frame
		while victim.get_available_packet_count() > 0:
			received += victim.get_packet().size()
	return received
