extends "res://tests/framework/network_test.gd"
## MotorSynchronizer: what a peer sends that it has no right to changes nothing, costs little and is told.

# 0x40, the version (1) times 4, the kind.
const MOTION := 0x46
const ANSWER := 0x47
const HELLO := 0x44
const BYE := 0x45

## A packet that the server sent to a client, as seen by that client.
var _seen: Array[PackedByteArray] = []


func test_motion_from_a_peer_that_owns_nothing() -> void:
	await connect_peers(2, 3)
	await _listen(branches[1])
	# The client sends the server what the server sent to it, and packets of its own making.
	for packet in _seen:
		branches[1].api.send_bytes(packet, 1, MultiplayerPeer.TRANSFER_MODE_UNRELIABLE)
	await _bombard(branches[1], branches[0], 300, MOTION)
	await _expect_unmoved(branches[0])
	_expect_rejections(
		branches[0],
		branches[1],
		"Packet refused: its sender is the authority of no target here (",
		300 + _seen.size()
	)
	# The other client notices nothing.
	await expect_motion(0.3, [branches[2]])
	expect_equal(branches[2].rejections, [] as Array[Array], "what the other client rejected")


func test_nonsense_from_the_authority() -> void:
	await connect_peers(1, 3)
	await _listen(branches[1])
	await move(branches[0], SETTLE)
	var random := RandomNumberGenerator.new()
	random.seed = 4
	var sent := 0
	for packet: PackedByteArray in _seen.slice(0, 20):
		# Cut, damaged, lengthened.
		for variant: PackedByteArray in [
			packet.slice(0, maxi(5, packet.size() / 2)),
			_damaged(packet, random),
			packet + PackedByteArray([1, 2, 3, 4, 5, 6])
		]:
			branches[0].api.send_bytes(
				variant, branches[1].api.get_unique_id(), MultiplayerPeer.TRANSFER_MODE_UNRELIABLE
			)
			sent += 1
	expect_true(sent >= 12, "%d damaged packets" % sent)
	await expect_motion(0.4, [branches[1]])
	for body: Node3D in branches[1].synchronizer.get_active_targets():
		expect_true(body.transform.is_finite(), "a finite transform of %s" % body.name)


func test_answers_and_goodbyes_from_a_stranger() -> void:
	await connect_peers(1, 2)
	# A client that makes no use of the synchronizer.
	var stranger := make_branch("Stranger")
	var server_peer: ENetMultiplayerPeer = branches[0].api.multiplayer_peer
	stranger.join(server_peer.host.get_local_port())
	await wait_until(stranger.is_joined, "the stranger being connected")
	await _bombard(stranger, branches[0], 50, ANSWER)
	await _bombard(stranger, branches[0], 50, BYE)
	await wait_until(func() -> bool: return branches[0].rejections.size() >= 2, "two reports", 3.0)
	var reasons := ""
	for rejection in branches[0].rejections:
		expect_equal(rejection[0], stranger.api.get_unique_id(), "the peer")
		var reason: String = rejection[1]
		reasons += reason
	expect_true(
		(
			reasons.contains("it answers a stream that its sender does not get")
			and reasons.contains("it is malformed")
		),
		"reasons: %s" % reasons
	)
	await expect_motion(0.3, [branches[1]])


func test_a_stranger_that_asks_again_and_again_gets_one_stream() -> void:
	await connect_peers(1, 40)
	await move(branches[0], SETTLE)
	var before: float = branches[0].synchronizer.get_statistics()["sent_bytes_per_second"]
	for tick in 45:
		for i in 20:
			var hello := _envelope(branches[0], HELLO)
			hello[3] = randi_range(0, 255)
			branches[1].api.send_bytes(hello, 1, MultiplayerPeer.TRANSFER_MODE_UNRELIABLE)
		await move(branches[0], 1.0 / 60.0)
	var after: float = branches[0].synchronizer.get_statistics()["sent_bytes_per_second"]
	expect_true(after < 8.0 * before + 20000.0, "%d bytes a second, %d before," % [after, before])
	# What the stranger took from itself it asks for again.
	await move(branches[0], 1.0)
	await expect_motion(0.3, [branches[1]])


func test_another_version_is_told() -> void:
	await connect_peers(1, 1)
	await move(branches[0], 0.3)
	var packet := _envelope(branches[0], MOTION)
	packet[0] = packet[0] ^ 0x08
	branches[1].api.send_bytes(packet, 1)
	await wait_until(func() -> bool: return not branches[0].rejections.is_empty(), "a report")
	expect_equal(
		branches[0].rejections,
		(
			[
				[
					branches[1].api.get_unique_id(),
					"Packet refused: it is of another version of GA-Godot; use the same on all peers (1 since the last report)."
				]
			]
			as Array[Array]
		)
	)


func test_what_is_somebody_elses_is_left_alone() -> void:
	await connect_peers(1, 1)
	var heard := PackedStringArray()
	branches[0].api.peer_packet.connect(
		func(_peer: int, packet: PackedByteArray) -> void:
			if packet[0] == 0x63:
				heard.append(packet.get_string_from_ascii())
	)
	await move(branches[0], 0.4)
	for i in 30:
		branches[1].api.send_bytes(("chat %d" % i).to_ascii_buffer(), 1)
		var foreign := _envelope(branches[0], MOTION)
		foreign[1] = foreign[1] ^ 1
		branches[1].api.send_bytes(foreign, 1)
		branches[1].api.send_bytes(PackedByteArray([MOTION]), 1)
	await move(branches[0], 0.2)
	expect_equal(heard.size(), 30, "messages of the game's own")
	expect_equal(branches[0].synchronizer.get_statistics()["rejected"], 0, "rejected")


## A peer adds a body of somebody else's to its own stream.
func test_a_stranger_in_an_own_stream_is_ignored() -> void:
	await connect_peers(1, 2)
	var client: int = branches[1].api.get_unique_id()
	# The client believes that both are its own, the server only one.
	branches[0].get_body(1).set_multiplayer_authority(client)
	branches[1].get_body(0).set_multiplayer_authority(client)
	branches[1].get_body(1).set_multiplayer_authority(client)
	await move(branches[1], SETTLE)
	expect_true(distance_from_path(branches[0].get_body(1)) < 0.008, "the client's own being shown")
	expect_equal(branches[0].get_body(0).position, Vector3.ZERO, "place of the server's own")
	expect_equal(branches[0].synchronizer.get_statistics()["foreign"], 1, "foreign bodies")


## 10,000 bad packets a second must not take a tenth of the time.
func test_rejecting_is_cheap() -> void:
	await connect_peers(1, 1)
	await move(branches[0], 0.3)
	var packet := _envelope(branches[0], MOTION)
	packet.resize(200)
	var count := 10000
	var started := Time.get_ticks_usec()
	for i in count:
		branches[0].synchronizer.call(&"_on_peer_packet", branches[1].api.get_unique_id(), packet)
	var seconds := (Time.get_ticks_usec() - started) * 1e-6
	expect_equal(branches[0].synchronizer.get_statistics()["rejected"], count, "rejected")
	expect_true(seconds < 0.05, "%.1f ms for %d packets" % [seconds * 1000.0, count])
	await move(branches[0], 0.1)
	expect_equal(branches[0].rejections.size(), 1, "reports")


func _listen(client: NetworkBranch) -> void:
	client.api.peer_packet.connect(
		func(_peer: int, packet: PackedByteArray) -> void:
			if packet[0] == MOTION and _seen.size() < 60:
				_seen.append(packet)
	)
	await move(branches[0], 0.9)
	expect_true(_seen.size() >= 4, "%d packets that the client saw" % _seen.size())


## Packets with the synchronizer's mark and random content.
func _bombard(from: NetworkBranch, to: NetworkBranch, count: int, kind: int) -> void:
	var random := RandomNumberGenerator.new()
	random.seed = 8
	for i in count:
		var packet := _envelope(to, kind)
		for k in random.randi_range(2, 1000):
			packet.append(random.randi_range(0, 255))
		from.api.send_bytes(
			packet, to.api.get_unique_id(), MultiplayerPeer.TRANSFER_MODE_UNRELIABLE
		)
		if i % 50 == 49:
			await move(branches[0], 0.02)
	await move(branches[0], 0.1)


## The first four bytes of a packet of that kind; 255 is a link that nobody has.
func _envelope(branch: NetworkBranch, kind: int) -> PackedByteArray:
	var hash_value := 2166136261
	for byte: int in String(branch.root.get_path_to(branch.synchronizer)).to_utf8_buffer():
		hash_value = ((hash_value ^ byte) * 16777619) & 0xffffffff
	var key := (hash_value ^ (hash_value >> 16)) & 0xffff
	return PackedByteArray([kind, key & 0xff, key >> 8, 255])


func _damaged(packet: PackedByteArray, random: RandomNumberGenerator) -> PackedByteArray:
	var result := packet.duplicate()
	for i in 3:
		result[random.randi_range(4, result.size() - 1)] = random.randi_range(0, 255)
	return result


func _expect_unmoved(branch: NetworkBranch) -> void:
	for body: Node3D in branch.synchronizer.get_active_targets():
		expect_transform_near(
			body.transform, default_pose(body.name, time), 1e-5, "transform of %s" % body.name
		)


func _expect_rejections(
	branch: NetworkBranch, offender: NetworkBranch, beginning: String, least: int
) -> void:
	var peer: int = offender.api.get_unique_id()
	var statistics := branch.synchronizer.get_statistics()
	var peers: Dictionary = statistics["peers"]
	var of_offender: Dictionary = peers[peer]
	var rejected: int = of_offender["rejected"]
	expect_true(rejected >= least * 9 / 10, "%d of %d packets being rejected" % [rejected, least])
	expect_equal(statistics["rejected"], rejected, "rejected in total")
	expect_true(
		branch.rejections.size() >= 1 and branch.rejections.size() <= 8,
		"%d reports" % branch.rejections.size()
	)
	for rejection in branch.rejections:
		expect_equal(rejection[0], peer, "the peer")
		var reason: String = rejection[1]
		expect_true(reason.begins_with(beginning), "reason: %s" % reason)
