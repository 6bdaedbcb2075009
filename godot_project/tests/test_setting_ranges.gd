extends "res://tests/framework/test_case.gd"
## Settings and times outside their ranges are errors, which name both, and change nothing.

const RANGES: Dictionary[String, String] = {
	"position_tolerance": "1e-06 to 1000000 meters",
	"rotation_tolerance": "0.01 to 30 degrees",
	"max_latency": "0.001 to 10 seconds",
	"send_rate": "0.01 to 10000 Hz",
	"ticks_per_second": "1 to 10000 Hz",
}
const WRONG: Dictionary[String, float] = {
	"0": 0.0,
	"-1": -1.0,
	"1e-09": 1e-9,
	"1e-300": 1e-300,
	"20000000": 2e7,
	"1e+300": 1e300,
	"-1e+300": -1e300,
	"inf": INF,
	"-inf": -INF,
	"nan": NAN,
}


func test_values_outside_the_ranges_change_nothing() -> void:
	var sender := MotorSender.new()
	for property: String in RANGES:
		var before: float = sender.get(property)
		for text: String in WRONG:
			expect_error(
				"MotorSender: %s is %s, but must be %s." % [property, text, RANGES[property]]
			)
			sender.set(property, WRONG[text])
			expect_equal(sender.get(property), before, property)


func test_receivers_accept_the_ends_of_the_ranges() -> void:
	for property: String in RANGES:
		var limits := RANGES[property].split(" ")
		for limit: String in [limits[0], limits[2]]:
			var sender := MotorSender.new()
			sender.max_latency = 0.02
			sender.set(property, limit.to_float())
			var value: float = sender.get(property)
			expect_near(value / limit.to_float(), 1.0, 1e-9, property)
			sender.add_body(1, Transform3D.IDENTITY)
			sender.add_receiver(1, 0.0)
			var receiver := MotorReceiver.new()
			for packet in sender.flush(0.0):
				expect_equal(receiver.accept(packet.bytes as PackedByteArray, 0.0), "", property)
			expect_true(receiver.is_ready(), "the receiver is ready with %s %s" % [property, limit])


func test_latency_is_limited_in_ticks() -> void:
	var sender := MotorSender.new()
	sender.max_latency = 10.0
	expect_error(
		(
			"MotorSender: max_latency would be 10 seconds, or 10000 ticks, but must be at most "
			+ "2048 ticks."
		)
	)
	sender.ticks_per_second = 1000.0
	expect_near(sender.ticks_per_second, 60.0, 1e-9)
	sender.max_latency = 2.0
	sender.ticks_per_second = 1000.0
	expect_error(
		(
			"MotorSender: max_latency would be 3 seconds, or 3000 ticks, but must be at most 2048 "
			+ "ticks."
		)
	)
	sender.max_latency = 3.0
	expect_near(sender.max_latency, 2.0, 1e-9)


func test_times_outside_the_range_have_no_effect() -> void:
	var sender := MotorSender.new()
	var receiver := MotorReceiver.new()
	sender.add_body(1, Transform3D.IDENTITY)
	sender.add_receiver(1, 0.0)
	var bytes: PackedByteArray = sender.flush(0.0)[0].bytes
	var times: Dictionary[String, float] = {"nan": NAN, "1e+18": 1e18, "-inf": -INF}
	for text: String in times:
		var message := "%s: the time is " + text + ", but must be -1e12 to 1e12 seconds."
		for method: String in ["add_receiver", "observe", "flush", "accept"]:
			expect_error(message % ("MotorSender." + method))
		sender.add_receiver(2, times[text])
		expect_true(not sender.observe(1, times[text], Transform3D.IDENTITY), "not observed")
		expect_equal(sender.flush(times[text]).size(), 0, "packets")
		expect_equal(sender.accept(1, bytes, times[text]), "the time is out of range")
		for method: String in ["accept", "take_ack", "advance"]:
			expect_error(message % ("MotorReceiver." + method))
		expect_equal(receiver.accept(bytes, times[text]), "the time is out of range")
		expect_equal(receiver.take_ack(times[text]).size(), 0, "acknowledgement")
		receiver.advance(times[text])
	expect_true(not sender.has_receiver(2), "receiver 2 was not added")
	expect_true(not receiver.is_ready(), "no packet was accepted")
	expect_equal(receiver.accept(bytes, 0.0), "", "the first packet")


func test_a_jump_of_the_clock_does_not_stop_a_stream() -> void:
	for jump: float in [86400.0, 1e9, -50.0]:
		var sender := MotorSender.new()
		var receiver := MotorReceiver.new()
		sender.add_body(1, Transform3D.IDENTITY)
		sender.add_receiver(1, 100.0)
		for tick in 240:
			var now := 100.0 + tick / 60.0
			var time := now + (jump if tick >= 120 else 0.0)
			sender.observe(1, time, Transform3D(Basis.IDENTITY, Vector3(tick, 0.0, 0.0)))
			for packet in sender.flush(time):
				expect_equal(receiver.accept(packet.bytes as PackedByteArray, now), "", "packet")
			receiver.advance(now)
			var ack := receiver.take_ack(now)
			if not ack.is_empty():
				expect_equal(sender.accept(1, ack, time), "", "acknowledgement")
		expect_true(receiver.get_transform(1).origin.x > 225.0, "the body is up to date")
