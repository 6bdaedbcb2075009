extends "res://tests/framework/test_case.gd"
## The multiplayer demo's network simulation: impairments of a line, determinism, and the proxy
## between real sockets.

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


func test_loss_has_the_configured_probability_and_is_independent() -> void:
	var conditions := LineConditions.new()
	conditions.loss = 0.2
	var bursts := _loss_bursts(conditions)
	expect_near(_sum(bursts) / float(COUNT), 0.2, 0.01, "loss")
	expect_near(_sum(bursts) / float(bursts.size()), 1.25, 0.04, "mean length of a loss burst")


func test_bursts_have_the_configured_mean_length() -> void:
	var conditions := LineConditions.new()
	conditions.loss = 0.1
	conditions.burst = 5.0
	var bursts := _loss_bursts(conditions)
	expect_near(_sum(bursts) / float(COUNT), 0.1, 0.015, "loss")
	expect_near(_sum(bursts) / float(bursts.size()), 5.0, 0.6, "mean length of a loss burst")


func test_loss_of_none_and_of_all() -> void:
	var conditions := LineConditions.new()
	conditions.burst = 4.0
	expect_equal(
		_run(conditions, 1, 1000).size(), 1000, "packets of 1000 that arrived without loss"
	)
	conditions.loss = 1.0
	expect_equal(
		_run(conditions, 1, 1000).size(), 0, "packets of 1000 that arrived with a loss of 1"
	)


func test_jitter_is_uniform() -> void:
	var conditions := LineConditions.new()
	conditions.delay = 0.05
	conditions.jitter = 0.1
	var min_transit := INF
	var max_transit := -INF
	var sum := 0.0
	for arrival: Vector2 in _run(conditions, 2, 5000):
		var transit := arrival.y - arrival.x * STEP
		min_transit = minf(min_transit, transit)
		max_transit = maxf(max_transit, transit)
		sum += transit
	# The line is polled every half millisecond.
	expect_near(min_transit, 0.05, 0.002, "minimum transit time")
	expect_near(max_transit, 0.15, 0.002, "maximum transit time")
	expect_near(sum / 5000.0, 0.1, 0.002, "mean transit time")


func test_reordering_has_the_configured_probability() -> void:
	var conditions := LineConditions.new()
	conditions.delay = 0.02
	conditions.reorder = 0.1
	var reordered := 0
	var newest := -1.0
	for arrival: Vector2 in _run(conditions, 3, 5000):
		reordered += int(arrival.x < newest)
		newest = maxf(newest, arrival.x)
	expect_near(reordered / 5000.0, 0.1, 0.015, "share of reordered packets")


func test_duplication_has_the_configured_probability() -> void:
	var conditions := LineConditions.new()
	conditions.duplicate = 0.25
	conditions.jitter = 0.03
	expect_near(_run(conditions, 4, 5000).size() / 5000.0, 1.25, 0.02, "copies per packet")


func test_rate_limits_throughput_and_delay() -> void:
	var conditions := LineConditions.new()
	# 100 packets per second of 72 + 28 bytes are sent; half of them fit.
	conditions.rate = 5000.0
	var line := ImpairedLine.new(1)
	line.conditions = conditions
	var arrived := 0
	var max_wait := 0.0
	for i: int in 1000:
		var packet := PackedByteArray()
		packet.resize(72)
		packet.encode_double(0, i * STEP)
		line.put(packet, i * STEP)
		for other: PackedByteArray in line.take(i * STEP):
			arrived += 1
			max_wait = maxf(max_wait, i * STEP - other.decode_double(0))
	expect_near(arrived, 500.0, 15.0, "packets that arrived in 10 s")
	expect_near(line.overflowed, 485.0, 15.0, "packets dropped because the queue was full")
	expect_near(max_wait, ImpairedLine.MAX_QUEUE + 0.02, 0.02, "maximum wait")


func test_same_seed_gives_the_same_run() -> void:
	var conditions := _bad_conditions()
	expect_equal(_run(conditions, 7, 2000), _run(conditions, 7, 2000), "arrivals of the second run")
	expect_true(
		_run(conditions, 7, 2000) != _run(conditions, 8, 2000), "another seed gives another run"
	)


func test_losses_do_not_depend_on_the_other_impairments() -> void:
	var bad := _bad_conditions()
	var lossy := LineConditions.new()
	lossy.loss = bad.loss
	lossy.burst = bad.burst
	expect_equal(_arrived(bad, 9), _arrived(lossy, 9), "packets that arrive")


func test_conditions_change_immediately() -> void:
	var line := ImpairedLine.new(1)
	line.put(PackedByteArray([1]), 0.0)
	expect_equal(line.take(0.0).size(), 1, "packets that arrived at once")
	line.conditions.delay = 0.5
	line.put(PackedByteArray([2]), 1.0)
	line.conditions.delay = 0.0
	line.put(PackedByteArray([3]), 1.1)
	expect_equal(line.take(1.1), [PackedByteArray([3])] as Array[PackedByteArray], "first arrival")
	expect_equal(line.take(1.5).size(), 1, "packets that arrived after the delay")


func test_packets_in_transit_are_bounded() -> void:
	var line := ImpairedLine.new(1)
	line.conditions.delay = 1000.0
	for i: int in ImpairedLine.MAX_IN_TRANSIT + 10:
		line.put(PackedByteArray([1]), 0.0)
	expect_equal(line.overflowed, 10, "dropped packets")


func test_proxy_serves_several_clients_in_both_directions() -> void:
	var server := _listen()
	var proxy := _make_proxy(server)
	var clients: Array[PacketPeerUDP] = [_connect(proxy), _connect(proxy), _connect(proxy)]
	for i: int in clients.size():
		expect_equal(
			await _exchange(clients[i], server, "request %d" % i),
			"reply to request %d" % i,
			"reply"
		)
	var counts := proxy.get_counts()
	expect_equal(
		[counts.up_packets, counts.down_packets, counts.down_lost],
		[3, 3, 0],
		"packets up, down, lost"
	)
	expect_equal(counts.up_bytes, 27, "bytes up")


func test_proxy_applies_loss_and_delay() -> void:
	var server := _listen()
	var proxy := _make_proxy(server)
	var client := _connect(proxy)
	var conditions := LineConditions.new()
	conditions.loss = 1.0
	proxy.set_conditions(conditions)
	expect_equal(
		await _exchange(client, server, "lost", 0.3),
		"",
		"reply through a line that loses everything"
	)
	conditions = LineConditions.new()
	conditions.delay = 0.1
	proxy.set_conditions(conditions)
	var begin := Time.get_ticks_usec()
	expect_equal(await _exchange(client, server, "late"), "reply to late", "reply")
	var round_trip := (Time.get_ticks_usec() - begin) * 1e-6
	expect_true(round_trip >= 0.2, "a round trip of %.3f s takes 0.2 s or more" % round_trip)


## Polls between frames, so that only the proxy is measured.
func test_proxy_adds_little_delay() -> void:
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
	expect_duration_below(times[50], 2.0, "the way through the proxy")


## Sends [param count] packets, one per [constant STEP]; returns the number and the arrival time
## of those that arrive.
func _run(conditions: LineConditions, seed_value: int, count: int) -> PackedVector2Array:
	var line := ImpairedLine.new(seed_value)
	line.conditions = conditions
	var arrived := PackedVector2Array()
	var polls := 20 if conditions.delay + conditions.jitter > 0.0 else 1
	for i: int in count + 100:
		if i < count:
			var packet := PackedByteArray()
			packet.resize(4)
			packet.encode_u32(0, i)
			line.put(packet, i * STEP)
		for poll: int in polls:
			var now := (i + poll / float(polls)) * STEP
			for packet: PackedByteArray in line.take(now):
				arrived.append(Vector2(packet.decode_u32(0), now))
	return arrived


## The numbers of the packets that arrive, sorted.
func _arrived(conditions: LineConditions, seed_value: int) -> PackedInt32Array:
	var numbers: Dictionary[int, bool] = {}
	for arrival: Vector2 in _run(conditions, seed_value, 2000):
		numbers[int(arrival.x)] = true
	var sorted := PackedInt32Array(numbers.keys())
	sorted.sort()
	return sorted


## The length of each burst of losses.
func _loss_bursts(conditions: LineConditions) -> PackedInt32Array:
	var line := ImpairedLine.new(6)
	line.conditions = conditions
	var bursts := PackedInt32Array()
	var was_lost := false
	for i: int in COUNT:
		line.put(PackedByteArray(), i * STEP)
		var is_lost := line.take(i * STEP).is_empty()
		if is_lost and was_lost:
			bursts[-1] += 1
		elif is_lost:
			bursts.append(1)
		was_lost = is_lost
	return bursts


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


## Sends a request, has the server reply to every request, and returns the reply; empty after a
## timeout.
func _exchange(
	client: PacketPeerUDP, server: PacketPeerUDP, request: String, seconds := WAIT_SECONDS
) -> String:
	client.put_packet(request.to_utf8_buffer())
	var end := Time.get_ticks_usec() + int(seconds * 1e6)
	while Time.get_ticks_usec() < end:
		await wait_frames(1)
		if server.get_available_packet_count() > 0:
			var text := server.get_packet().get_string_from_utf8()
			server.set_dest_address(server.get_packet_ip(), server.get_packet_port())
			server.put_packet(("reply to " + text).to_utf8_buffer())
		if client.get_available_packet_count() > 0:
			return client.get_packet().get_string_from_utf8()
	return ""
