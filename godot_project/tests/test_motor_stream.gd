extends "res://tests/framework/test_case.gd"
## MotorSender and MotorReceiver, connected without a network.

const TICK := 1.0 / 60.0

var _sender := MotorSender.new()
var _receiver := MotorReceiver.new()
var _tick := 0


func test_properties() -> void:
	expect_near(_sender.position_tolerance, 0.005, 1e-9, "position_tolerance")
	expect_near(_sender.rotation_tolerance, 1.4, 1e-9, "rotation_tolerance")
	expect_near(_sender.max_latency, 0.1, 1e-9, "max_latency")
	expect_near(_sender.send_rate, 20.0, 1e-9, "send_rate")
	expect_near(_sender.ticks_per_second, 60.0, 1e-9, "ticks_per_second")
	expect_equal(_sender.mode, MultivectorLerp.SEPARATE, "mode")
	expect_equal(_sender.max_packet_size, 1100, "max_packet_size")
	expect_equal(_receiver.max_bodies, 65536, "max_bodies")
	expect_near(_receiver.min_delay, 0.0, 1e-9, "min_delay")
	expect_near(_receiver.jitter_allowance, 0.2, 1e-9, "jitter_allowance")
	expect_error("MotorSender: ticks_per_second is 0, but must be 1 to 10000 Hz.")
	_sender.ticks_per_second = 0.0
	expect_error("MotorSender: send_rate is -2, but must be 0.01 to 10000 Hz.")
	_sender.send_rate = -2.0
	expect_error("MotorSender: max_packet_size is 65001, but must be 256 to 65000 bytes.")
	_sender.max_packet_size = 65001
	expect_equal(_sender.max_packet_size, 1100, "max_packet_size")
	expect_error("MotorReceiver: max_bodies is 0, but must be 1 to 16777215 bodies.")
	_receiver.max_bodies = 0
	expect_near(_sender.send_rate, 20.0, 1e-9, "send_rate")


func test_bodies_appear_move_and_vanish() -> void:
	var events := PackedStringArray()
	_receiver.body_added.connect(func(id: int) -> void: events.append("+%d" % id))
	_receiver.body_removed.connect(func(id: int) -> void: events.append("-%d" % id))
	expect_true(not _receiver.is_ready(), "the receiver is not ready yet")
	_start(3)
	var worst := 0.0
	for i in 90:
		_step()
		if i > 40:
			for id in 3:
				worst = maxf(
					worst,
					_receiver.get_transform(id).origin.distance_to(
						_pose(id, _receiver.get_media_time()).origin
					)
				)
	expect_true(
		worst > 0.0 and worst < 0.006,
		"the maximum error of %.2f mm is below 6 mm" % (worst * 1000.0)
	)
	expect_true(_receiver.is_ready(), "the receiver is ready")
	expect_equal(_receiver.get_bodies().size(), 3, "number of bodies")
	expect_true(
		_receiver.get_known_time() > _receiver.get_media_time(), "known_time is ahead of media_time"
	)
	expect_true(_sender.get_moving_count() >= 3, "at least 3 bodies move")
	expect_true(_sender.remove_body(1), "body 1 is removed")
	expect_true(not _sender.remove_body(1), "body 1 cannot be removed twice")
	for i in 60:
		_step()
	expect_true(
		_receiver.has_body(0) and not _receiver.has_body(1),
		"the receiver has body 0 but not body 1"
	)
	expect_equal(_sender.get_body_count(), 2, "bodies of the sender")
	events.sort()
	expect_equal(events, PackedStringArray(["+0", "+1", "+2", "-1"]), "events")


func test_statistics() -> void:
	_start(3)
	for i in 60:
		_step()
	var sent := _sender.get_statistics(7)
	var received := _receiver.get_statistics()
	expect_equal(received["bytes_received"], sent["bytes_sent"], "bytes")
	expect_equal(received["packets_received"], sent["packets_sent"], "packets")
	expect_equal(received["packets_rejected"], 0, "rejected")
	expect_equal(sent["chunks_repeated"], 0, "repeated")
	var delay: float = received["playback_delay"]
	expect_true(
		delay > 0.0 and delay < 0.5, "a playback delay of %s s is between 0 and 0.5 s" % delay
	)
	_sender.remove_receiver(7)
	expect_true(not _sender.has_receiver(7), "the receiver is removed")
	expect_equal(_sender.flush(_tick * TICK + TICK).size(), 0, "packets without receivers")


func test_a_priority_divides_the_error_over_a_line_that_carries_less() -> void:
	const COUNT := 100
	const BYTES_PER_TICK := 50.0
	for id in COUNT:
		_sender.add_body(id, _fast_pose(id, 0.0))
	expect_true(_sender.set_priority(0, 3), "the priority of body 0 is set")
	_sender.add_receiver(7, 0.0)
	var waiting: Array[Array] = []  # [tick of arrival, packet]
	var free_at := 0.0  # tick at which the line is free
	var ranked := 0.0
	var others := 0.0
	var relaxation := 1.0
	for tick in 1200:
		var now := tick * TICK
		for id in COUNT:
			_sender.observe(id, now, _fast_pose(id, now))
		for packet in _sender.flush(now):
			var bytes: PackedByteArray = packet["bytes"]
			var arrival := maxf(tick, free_at) + bytes.size() / BYTES_PER_TICK
			if arrival - tick < 30.0:
				free_at = arrival
				waiting.append([arrival, bytes])
		while not waiting.is_empty() and waiting[0][0] <= tick:
			_receiver.accept(waiting.pop_front()[1] as PackedByteArray, now)
		_receiver.advance(now)
		var ack := _receiver.take_ack(now)
		if not ack.is_empty():
			_sender.accept(7, ack, now)
		var shown := _receiver.get_media_time()
		if tick < 600 or shown > _receiver.get_known_time():
			continue
		var statistics := _sender.get_statistics(7)
		relaxation = maxf(relaxation, statistics["relaxation"] as float)
		for id in COUNT:
			var error := _receiver.get_transform(id).origin.distance_to(
				_fast_pose(id, shown).origin
			)
			ranked += error if id == 0 else 0.0
			others += error / (COUNT - 1) if id > 0 else 0.0
	expect_true(relaxation >= 4.0, "errors are up to %s times the tolerances" % relaxation)
	expect_equal(nearest_po2(int(relaxation)), int(relaxation), "a power of two")
	expect_true(others > 2.5 * ranked, "errors are %s times those of body 0" % (others / ranked))


func test_teleport() -> void:
	_start(1)
	for i in 40:
		_step()
	_sender.teleport(0)
	var between := 0
	for i in 60:
		_step(Vector3(500, 0, 0))
		between += int(absf(_receiver.get_transform(0).origin.x - 250.0) < 240.0)
	expect_equal(between, 0, "frames between the two places")
	expect_near(_receiver.get_transform(0).origin.x, 500.0, 3.0, "x")


func test_invalid_packets_and_arguments_are_rejected() -> void:
	_start(1)
	expect_true(
		_receiver.accept(PackedByteArray([255, 255, 255]), 0.0) != "",
		"a reason for an invalid packet"
	)
	expect_true(_receiver.accept(PackedByteArray(), 0.0) != "", "a reason for an empty packet")
	expect_equal(
		_sender.accept(99, PackedByteArray([1]), 0.0),
		"the acknowledgement comes from a peer that is not a receiver",
		"reason"
	)
	expect_true(
		_sender.accept(7, PackedByteArray([255, 255, 255]), 0.0) != "",
		"a reason for an invalid acknowledgement"
	)
	expect_error("MotorSender.add_body: body 0 exists already.")
	expect_true(not _sender.add_body(0, Transform3D.IDENTITY), "a body cannot be added twice")
	expect_error("MotorSender.add_body: id is -1, but must be 0 to 2147483647.")
	_sender.add_body(-1, Transform3D.IDENTITY)
	expect_error("MotorSender.observe: body 5 does not exist; call add_body() first.")
	_sender.observe(5, 0.0, Transform3D.IDENTITY)
	expect_error(
		(
			"MotorSender.observe: the transform of body 0 is mirrored (negative scale), which "
			+ "a motor cannot represent; mirror a child node instead."
		)
	)
	_sender.observe(
		0, 0.0, Transform3D(Vector3(-1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3.ZERO)
	)
	expect_error("MotorSender.teleport: body 5 does not exist.")
	_sender.teleport(5)
	expect_error("MotorSender.set_priority: body 5 does not exist.")
	expect_true(not _sender.set_priority(5, 1), "a body that does not exist has no priority")
	for priority: int in [-1, 9, 1 << 32]:
		expect_error("MotorSender.set_priority: the priority is %d, but must be 0 to 8." % priority)
		expect_true(not _sender.set_priority(0, priority), "priority %d is refused" % priority)
	expect_true(_sender.set_priority(0, 8), "priority 8 is accepted")
	expect_error("MotorSender.flush: the time is nan, but must be -1e12 to 1e12 seconds.")
	_sender.flush(NAN)
	expect_error("MotorSender.get_statistics: receiver 8 does not exist.")
	_sender.get_statistics(8)
	expect_error(
		(
			"MotorReceiver.get_transform: body 6 does not exist at the media time shown. Check "
			+ "has_body() first, or follow the signals."
		)
	)
	_receiver.get_transform(6)


func test_receiver_restarts_after_clear() -> void:
	_start(2)
	for i in 40:
		_step()
	expect_error("MotorReceiver: set max_bodies before the first packet, or call clear() first.")
	_receiver.max_bodies = 10
	_receiver.clear()
	_receiver.max_bodies = 10
	expect_true(
		not _receiver.is_ready() and _receiver.get_bodies().is_empty(),
		"the receiver is empty after clear()"
	)
	_sender.add_receiver(7, _tick * TICK)
	for i in 40:
		_step()
	expect_equal(_receiver.get_bodies().size(), 2, "number of bodies")


func _start(bodies: int) -> void:
	for id in bodies:
		expect_true(_sender.add_body(id, _pose(id, 0.0)), "body %d is added" % id)
		expect_true(_sender.has_body(id), "the sender has body %d" % id)
	_sender.add_receiver(7, 0.0)


func _step(offset := Vector3.ZERO) -> void:
	_tick += 1
	var now := _tick * TICK
	for id in 3:
		if _sender.has_body(id):
			_sender.observe(id, now, Transform3D(Basis.IDENTITY, offset) * _pose(id, now))
	for packet in _sender.flush(now):
		expect_equal(packet["receiver"], 7, "receiver")
		var bytes: PackedByteArray = packet["bytes"]
		expect_equal(_receiver.accept(bytes, now), "", "rejection of a packet")
	_receiver.advance(now)
	var ack := _receiver.take_ack(now)
	if not ack.is_empty():
		expect_equal(_sender.accept(7, ack, now), "", "rejection of an acknowledgement")


func _pose(id: int, seconds: float) -> Transform3D:
	return Transform3D(
		Basis(Vector3(1, id, 0.5).normalized(), seconds),
		Vector3(id * 3.0 + cos(seconds), 0.5, sin(seconds))
	)


func _fast_pose(id: int, seconds: float) -> Transform3D:
	var angle := seconds * 4.0 + id
	var place := Vector3(sin(angle) + 0.3 * sin(3.7 * angle), id, cos(1.3 * angle))
	return Transform3D(Basis(Vector3(0.6, 0.0, 0.8), angle * 0.7), place)
