extends "res://tests/framework/test_case.gd"
## The multiplayer demo's bad network: what a line does to packets, that it repeats, and the proxy between real sockets.

const ImpairedLine := preload("res://demos/multiplayer/network/impaired_line.gd")
const LineConditions := preload("res://demos/multiplayer/network/line_conditions.gd")
const UdpProxy := preload("res://demos/multiplayer/network/udp_proxy.gd")

const COUNT := 20000
## Seconds between two packets.
const STEP := 0.01
const WAIT_SECONDS := 10.0
const LOOPBACK := "127.0.0.1"


func test_a_perfect_line_changes_nothing() -> void:
	var run := _run(LineConditions.new(), 5, 500)
	expect_equal(run.size(), 500, "packets")
	for i: int in run.size():
		if run[i] != Vector2(i, i * STEP):
			fail("packet %d arrived as %s" % [i, run[i]])


func test_loss_is_as_often_as_asked_and_independent() -> void:
	var conditions := LineConditions.new()
	conditions.loss = 0.2
	var rows := _loss_rows(conditions)
	expect_near(_sum(rows) / float(COUNT), 0.2, 0.01, "share lost")
	expect_near(_sum(rows) / float(rows.size()), 1.25, 0.04, "packets lost in a row")


func test_burst_loss_has_the_mean_length_asked() -> void:
	var conditions := LineConditions.new()
	conditions.loss = 0.1
	conditions.burst = 5.0
	var rows := _loss_rows(conditions)
	expect_near(_sum(rows) / float(COUNT), 0.1, 0.015, "share lost")
	expect_near(_sum(rows) / float(rows.size()), 5.0, 0.6, "packets lost in a row")


func test_all_and_nothing_are_lost_at_the_ends_of_the_scale() -> void:
	var conditions := LineConditions.new()
	conditions.burst = 4.0
	expect_equal(_run(conditions, 1, 1000).size(), 1000, "arrived of 1000 without loss")
	conditions.loss = 1.0
	expect_equal(_run(conditions, 1, 1000).size(), 0, "arrived of 1000 with nothing but loss")


func test_delay_and_jitter_spread_evenly() -> void:
	var conditions := LineConditions.new()
	conditions.delay = 0.05
	conditions.jitter = 0.1
	var least := INF
	var most := -INF
	var sum := 0.0
	for arrival: Vector2 in _run(conditions, 2, 5000):
		var took := arrival.y - arrival.x * STEP
		least = minf(least, took)
		most = maxf(most, took)
		sum += took
	# Arrivals are looked for every half millisecond.
	expect_near(least, 0.05, 0.002, "shortest time")
	expect_near(most, 0.15, 0.002, "longest time")
	expect_near(sum / 5000.0, 0.1, 0.002, "mean time")


func test_reordering_lets_a_share_be_overtaken() -> void:
	var conditions := LineConditions.new()
	conditions.delay = 0.02
	conditions.reorder = 0.1
	var overtaken := 0
	var newest := -1.0
	for arrival: Vector2 in _run(conditions, 3, 5000):
		overtaken += int(arrival.x < newest)
		newest = maxf(newest, arrival.x)
	expect_near(overtaken / 5000.0, 0.1, 0.015, "share of packets overtaken")


func test_duplicates_are_as_many_as_asked() -> void:
	var conditions := LineConditions.new()
	conditions.duplicate = 0.25
	conditions.jitter = 0.03
	expect_near(_run(conditions, 4, 5000).size() / 5000.0, 1.25, 0.02, "copies a packet")


func test_the_rate_bounds_throughput_and_delay() -> void:
	var conditions := LineConditions.new()
	# 100 packets a second of 72 + 28 bytes come; half of them fit.
	conditions.rate = 5000.0
	var line := ImpairedLine.new(1)
	line.conditions = conditions
	var arrived := 0
	var slowest := 0.0
	for i: int in 1000:
		var packet := PackedByteArray()
		packet.resize(72)
		packet.encode_double(0, i * STEP)
		line.put(packet, i * STEP)
		for other: PackedByteArray in line.take(i * STEP):
			arrived += 1
			slowest = maxf(slowest, i * STEP - other.decode_double(0))
	expect_near(arrived, 500.0, 15.0, "packets that passed in 10 s")
	expect_near(line.overflowed, 485.0, 15.0, "packets thrown away before the queue")
	expect_near(slowest, ImpairedLine.MAX_QUEUE + 0.02, 0.02, "longest wait")


func test_the_same_seed_is_the_same_fate() -> void:
	var conditions := _bad_conditions()
	expect_equal(_run(conditions, 7, 2000), _run(conditions, 7, 2000), "the second run")
	expect_true(
		_run(conditions, 7, 2000) != _run(conditions, 8, 2000), "another seed being another run"
	)


func test_what_is_lost_does_not_depend_on_the_other_conditions() -> void:
	var bad := _bad_conditions()
	var lossy := LineConditions.new()
	lossy.loss = bad.loss
	lossy.burst = bad.burst
	expect_equal(_arrived(bad, 9), _arrived(lossy, 9), "the packets that arrive")


func test_conditions_change_at_once() -> void:
	var line := ImpairedLine.new(1)
	line.put(PackedByteArray([1]), 0.0)
	expect_equal(line.take(0.0).size(), 1, "arrived at once")
	line.conditions.delay = 0.5
	line.put(PackedByteArray([2]), 1.0)
	line.conditions.delay = 0.0
	line.put(PackedByteArray([3]), 1.1)
	expect_equal(
		line.take(1.1), [PackedByteArray([3])] as Array[PackedByteArray], "the later packet first"
	)
	expect_equal(line.take(1.5).size(), 1, "the delayed one after its time")


func test_what_is_held_is_bounded() -> void:
	var line := ImpairedLine.new(1)
	line.conditions.delay = 1000.0
	for i: int in ImpairedLine.MAX_HELD + 10:
		line.put(PackedByteArray([1]), 0.0)
	expect_equal(line.overflowed, 10, "packets thrown away")


func test_the_proxy_serves_several_clients_both_ways() -> void:
	var server := _listen()
	var proxy := _make_proxy(server)
	var clients: Array[PacketPeerUDP] = [_connect(proxy), _connect(proxy), _connect(proxy)]
	for i: int in clients.size():
		expect_equal(
			await _exchange(clients[i], server, "question %d" % i),
			"answer to question %d" % i,
			"answer"
		)
	var counts := proxy.get_counts()
	expect_equal(
		[counts.up_packets, counts.down_packets, counts.down_lost],
		[3, 3, 0],
		"packets up, down, lost"
	)
	expect_equal(counts.up_bytes, 30, "bytes up")


func test_the_proxy_loses_and_delays_as_told() -> void:
	var server := _listen()
	var proxy := _make_proxy(server)
	var client := _connect(proxy)
	var conditions := LineConditions.new()
	conditions.loss = 1.0
	proxy.set_conditions(conditions)
	expect_equal(
		await _exchange(client, server, "lost", 0.3),
		"",
		"answer through a line that loses everything"
	)
	conditions = LineConditions.new()
	conditions.delay = 0.1
	proxy.set_conditions(conditions)
	var begin := Time.get_ticks_usec()
	expect_equal(await _exchange(client, server, "late"), "answer to late", "answer")
	var took := (Time.get_ticks_usec() - begin) * 1e-6
	expect_true(took >= 0.2, "a round trip of %.3f s through 0.1 s each way" % took)


## Without a frame between question and answer, so that what is measured is the proxy alone.
func test_the_proxy_itself_takes_little_time() -> void:
	var server := _listen()
	var client := _connect(_make_proxy(server))
	await _exchange(client, server, "first")
	var times := PackedFloat64Array()
	for i: int in 100:
		var begin := Time.get_ticks_usec()
		client.put_packet(PackedByteArray([i]))
		while server.get_available_packet_count() == 0 and Time.get_ticks_usec() - begin < 100000:
			OS.delay_usec(20)
		server.get_packet()
		times.append((Time.get_ticks_usec() - begin) * 1e-3)
	times.sort()
	expect_true(times[50] < 2.0, "half of the packets passing within %.2f ms" % times[50])


## What arrives of [param count] packets put in at every [constant STEP]: the packet's number and the time.
func _run(conditions: LineConditions, seed_value: int, count: int) -> PackedVector2Array:
	var line := ImpairedLine.new(seed_value)
	line.conditions = conditions
	var arrived := PackedVector2Array()
	var looks := 20 if conditions.delay + conditions.jitter > 0.0 else 1
	for i: int in count + 100:
		if i < count:
			var packet := PackedByteArray()
			packet.resize(4)
			packet.encode_u32(0, i)
			line.put(packet, i * STEP)
		for look: int in looks:
			var now := (i + look / float(looks)) * STEP
			for packet: PackedByteArray in line.take(now):
				arrived.append(Vector2(packet.decode_u32(0), now))
	return arrived


## The numbers of the packets that arrive at all, in order.
func _arrived(conditions: LineConditions, seed_value: int) -> PackedInt32Array:
	var numbers: Dictionary[int, bool] = {}
	for arrival: Vector2 in _run(conditions, seed_value, 2000):
		numbers[int(arrival.x)] = true
	var sorted := PackedInt32Array(numbers.keys())
	sorted.sort()
	return sorted


## How many packets were lost in each row of losses.
func _loss_rows(conditions: LineConditions) -> PackedInt32Array:
	var line := ImpairedLine.new(6)
	line.conditions = conditions
	var rows := PackedInt32Array()
	var was_lost := false
	for i: int in COUNT:
		line.put(PackedByteArray(), i * STEP)
		var is_lost := line.take(i * STEP).is_empty()
		if is_lost and was_lost:
			rows[-1] += 1
		elif is_lost:
			rows.append(1)
		was_lost = is_lost
	return rows


func _sum(numbers: PackedInt32Array) -> int:
	var sum := 0
	for number: int in numbers:
		sum += number
	return sum


func _bad_conditions() -> LineConditions:
	var conditions := LineConditions.new()
	conditions.loss = 0.3
	conditions.burst = 2.0
	conditions.delay = 0.03
	conditions.jitter = 0.1
	conditions.reorder = 0.05
	conditions.duplicate = 0.05
	return conditions


func _listen() -> PacketPeerUDP:
	var server := PacketPeerUDP.new()
	server.bind(0, LOOPBACK)
	return server


func _make_proxy(server: PacketPeerUDP) -> UdpProxy:
	var proxy := UdpProxy.new()
	add_node(proxy)
	expect_equal(proxy.open("localhost", server.get_local_port(), 1), OK, "opening the proxy")
	return proxy


func _connect(proxy: UdpProxy) -> PacketPeerUDP:
	var client := PacketPeerUDP.new()
	client.connect_to_host(LOOPBACK, proxy.get_port())
	return client


## Sends a question, lets the server answer whatever it gets, and returns the answer; empty if none comes.
func _exchange(
	client: PacketPeerUDP, server: PacketPeerUDP, question: String, seconds := WAIT_SECONDS
) -> String:
	client.put_packet(question.to_utf8_buffer())
	var end := Time.get_ticks_usec() + int(seconds * 1e6)
	while Time.get_ticks_usec() < end:
		await wait_frames(1)
		if server.get_available_packet_count() > 0:
			var text := server.get_packet().get_string_from_utf8()
			server.set_dest_address(server.get_packet_ip(), server.get_packet_port())
			server.put_packet(("answer to " + text).to_utf8_buffer())
		if client.get_available_packet_count() > 0:
			return client.get_packet().get_string_from_utf8()
	return ""
