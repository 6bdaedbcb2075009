extends "res://tests/framework/test_case.gd"
## The multiplayer demo's replication without a network: sender, datagrams, timelines, clock, receiver.

const BodyTimeline := preload("res://demos/multiplayer/replication/body_timeline.gd")
const BodyTrack := preload("res://demos/multiplayer/replication/body_track.gd")
const ImpairedLine := preload("res://demos/multiplayer/network/impaired_line.gd")
const KeyReceiver := preload("res://demos/multiplayer/replication/motor_receiver.gd")
const KeySender := preload("res://demos/multiplayer/replication/motor_sender.gd")
const PlaybackClock := preload("res://demos/multiplayer/replication/playback_clock.gd")
const PoseDatagram := preload("res://demos/multiplayer/replication/pose_datagram.gd")

const TICK := 1.0 / 60.0
const BODIES := 30
const TICKS := 360
## Selection within 5 mm, quantisation to 1 mm and 0.2 degrees at a lever of 0.25 m.
const BOUND := 0.008


func test_a_timeline_does_not_depend_on_the_order_of_arrival() -> void:
	var straight := BodyTimeline.new()
	var mixed := BodyTimeline.new()
	for tick: int in [0, 6, 12, 15]:
		straight.insert(tick, _at(tick))
	for tick: int in [0, 15, 6, 12]:
		expect_true(mixed.insert(tick, _at(tick)), "key %d being new" % tick)
	expect_true(not mixed.insert(6, _at(99.0)), "a repeated key being ignored")
	for step: int in 40:
		var media := step * 0.5
		expect_vector_near(_shown(mixed, media), _shown(straight, media), 1e-6, "at %s" % media)


func test_a_timeline_passes_through_its_keys_and_holds_the_last() -> void:
	var timeline := BodyTimeline.new()
	timeline.insert(0, _at(0.0))
	timeline.insert(6, _at(3.0))
	expect_vector_near(_shown(timeline, 2.0), Vector3(1.0, 0.0, 0.0), 1e-5, "a third of the way")
	expect_vector_near(_shown(timeline, 6.0), Vector3(3.0, 0.0, 0.0), 1e-6, "at the key")
	expect_vector_near(_shown(timeline, 50.0), Vector3(3.0, 0.0, 0.0), 1e-6, "after the last key")
	expect_true(not timeline.insert(3, _at(9.0)), "a key from before what is shown being ignored")
	expect_vector_near(_shown(timeline, 51.0), Vector3(3.0, 0.0, 0.0), 1e-6, "after the old key")


func test_a_long_gap_is_rest() -> void:
	var timeline := BodyTimeline.new()
	timeline.insert(0, _at(0.0))
	timeline.insert(300, _at(1.0))
	expect_vector_near(_shown(timeline, 290.0), Vector3.ZERO, 1e-6, "at rest")
	expect_vector_near(_shown(timeline, 297.0), Vector3(0.5, 0.0, 0.0), 1e-5, "in the last span")


func test_playback_never_runs_backwards_and_keeps_its_delay() -> void:
	var clock := PlaybackClock.new()
	var random := RandomNumberGenerator.new()
	random.seed = 3
	var last := -INF
	var backwards := 0
	for frame: int in 1200:
		var local := 100.0 + frame * TICK
		if frame % 3 == 0:
			clock.observe(frame, local + random.randf_range(0.0, 0.04))
		var media := clock.advance(local)
		backwards += int(media < last)
		last = media
	expect_equal(backwards, 0, "steps backwards")
	var delay := 1199.0 - last
	expect_true(delay > PlaybackClock.SENDER_TICKS and delay < PlaybackClock.SENDER_TICKS + 6.0,
			"a delay of %.1f ticks, that of the sender and 0 to 40 ms of jitter," % delay)


func test_playback_recovers_when_the_server_loses_time() -> void:
	var clock := PlaybackClock.new()
	var media := 0.0
	var tick := 0
	for frame: int in 600:
		var local := frame * TICK
		# The server stands still for half a second.
		if frame < 300 or frame > 330:
			tick += 1
			if tick % 3 == 0:
				clock.observe(tick, local)
		media = clock.advance(local)
		if frame == 420:
			expect_true(tick - media > PlaybackClock.SENDER_TICKS - 1.0, "playback back behind the server")
	expect_near(tick - media, PlaybackClock.SENDER_TICKS + 1.0, 6.0, "delay in ticks")


func test_datagrams_are_bounded_and_come_back() -> void:
	var codec := MotorCodec.new()
	var groups: Array[PoseDatagram.Group] = []
	for age: int in 3:
		var group := PoseDatagram.Group.new()
		group.tick = 1000 - age
		for id: int in 250:
			group.add(id, _pose(id, 1000 - age))
		groups.append(group)
	var seen := 0
	for bytes: PackedByteArray in PoseDatagram.pack(1000, groups, codec):
		expect_true(bytes.size() <= PoseDatagram.MOST_BYTES, "a datagram of %d bytes" % bytes.size())
		var content := PoseDatagram.unpack(bytes, codec)
		expect_equal(content.problem, "", "problem")
		expect_equal(content.tick, 1000, "tick")
		for group: PoseDatagram.Group in content.groups:
			for i: int in group.ids.size():
				seen += 1
				var error := BodyTrack.distance(group.poses[i], _pose(group.ids[i], group.tick))
				if error > BOUND:
					fail("body %d at tick %d is off by %s" % [group.ids[i], group.tick, error])
	expect_equal(seen, 750, "poses")


func test_a_damaged_datagram_changes_nothing() -> void:
	var sender := _make_sender()
	var receiver := KeyReceiver.new(BODIES)
	for bytes: PackedByteArray in sender.make_state(0, _poses(0)):
		receiver.accept(bytes, 0.0)
	receiver.show(0.0)
	var before := receiver.pool.get_buffer()
	var rejected := 0
	for id: int in BODIES:
		sender.observe(id, 3, _pose(id, 90))
	var sound := sender.flush(3)[0]
	for size: int in sound.size():
		rejected += int(not receiver.accept(sound.slice(0, size), 0.1))
	# Cut between two groups a datagram is whole, and the one with nothing but a header says nothing.
	expect_true(rejected >= sound.size() - 4, "%d of %d cut datagrams being rejected" % [rejected, sound.size()])
	expect_equal(receiver.rejected_datagrams, rejected, "rejected")
	var foreign := KeySender.new()
	foreign.add_body(BODIES, 4, Transform3D.IDENTITY)
	expect_true(not receiver.accept(foreign.flush(6)[0], 0.1), "a body that does not exist being rejected")
	receiver.show(1.0)
	expect_equal(receiver.pool.get_buffer(), before, "what is shown")


func test_a_resting_body_costs_repeats_and_refreshes_only() -> void:
	var track := BodyTrack.new()
	track.start(0, Transform3D.IDENTITY)
	var keys := 0
	var repeats := 0
	for tick: int in range(1, 600):
		keys += int(track.observe(tick, Transform3D.IDENTITY, 0.005, 0.001))
		repeats += int(track.take_repeat(tick))
	expect_equal(keys, 0, "keys")
	expect_equal(repeats, BodyTrack.REPEATS.size(), "repeats")


func test_what_is_shown_stays_within_the_bound_at_every_tick() -> void:
	var worst := _play(0.0, 0.0)
	expect_true(worst.x > 0.0 and worst.x <= BOUND, "a largest error of %.2f mm" % (worst.x * 1000.0))
	expect_true(worst.y <= BOUND, "an error of %.2f mm at the end" % (worst.y * 1000.0))


func test_loss_and_jitter_heal() -> void:
	var worst := _play(0.3, 0.06)
	expect_true(worst.x > BOUND, "loss being felt at all (%.2f mm)" % (worst.x * 1000.0))
	expect_true(worst.y <= BOUND, "an error of %.2f mm at the end" % (worst.y * 1000.0))


## Sends and shows the motion of [method _pose]; the largest error while it plays and at its end.
func _play(loss: float, jitter: float) -> Vector2:
	var sender := _make_sender()
	var receiver := KeyReceiver.new(BODIES)
	var line := ImpairedLine.new(11)
	line.conditions.loss = loss
	line.conditions.jitter = jitter
	for bytes: PackedByteArray in sender.make_state(0, _poses(0)):
		receiver.accept(bytes, 0.0)
	var worst := Vector2.ZERO
	var shown := -1
	for tick: int in range(1, TICKS + 60):
		var local := tick * TICK
		for id: int in BODIES:
			sender.observe(id, tick, _pose(id, tick))
		for bytes: PackedByteArray in sender.flush(tick):
			line.put(bytes, local)
		for bytes: PackedByteArray in line.take(local):
			receiver.accept(bytes, local)
		var media := receiver.clock.advance(local)
		while shown + 1 <= media:
			shown += 1
			receiver.show(shown)
			for id: int in BODIES:
				var error := BodyTrack.distance(receiver.pool.get_transform(id), _pose(id, shown))
				worst.x = maxf(worst.x, error)
				if shown == TICKS + 30:
					worst.y = maxf(worst.y, error)
	expect_true(shown >= TICKS + 30, "the end being shown")
	return worst


func _make_sender() -> KeySender:
	var sender := KeySender.new()
	for id: int in BODIES:
		sender.add_body(id, 0, _pose(id, 0))
	return sender


func _poses(tick: int) -> Dictionary[int, Transform3D]:
	var poses: Dictionary[int, Transform3D] = {}
	for id: int in BODIES:
		poses[id] = _pose(id, tick)
	return poses


## A body waits, then bounces lower and lower while it turns and drifts, then rests.
func _pose(id: int, tick: int) -> Transform3D:
	var seconds := clampf((tick - 20 - id) * TICK, 0.0, 4.0)
	var phase := fmod(seconds, 0.5) - 0.25
	var height := maxf(4.9 * (0.0625 - phase * phase) * (1.0 - seconds / 4.0), 0.0)
	var axis := Vector3(sin(id), cos(id), 0.5).normalized()
	return Transform3D(Basis(axis, seconds * (1.0 + id * 0.1)), Vector3(id * 0.7 + seconds, height, seconds * 0.5))


func _at(x: float) -> Transform3D:
	return Transform3D(Basis.IDENTITY, Vector3(x, 0.0, 0.0))


func _shown(timeline: BodyTimeline, media: float) -> Vector3:
	var weight := timeline.advance(media)
	return MultivectorLerp.interpolate_transform(timeline.from, timeline.to, weight, MultivectorLerp.LINEAR).origin
