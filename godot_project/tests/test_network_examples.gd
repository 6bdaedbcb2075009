extends "res://tests/framework/test_case.gd"
## The examples of replication without Godot's multiplayer: over a UDP socket, and to a file.

const MotionPlayer := preload("res://demos/recording/motion_player.gd")
const MotionRecorder := preload("res://demos/recording/motion_recorder.gd")
const RawUdp := preload("res://demos/raw_udp/raw_udp.gd")
const Recording := preload("res://demos/recording/recording.gd")

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
