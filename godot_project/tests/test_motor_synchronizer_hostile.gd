extends "res://tests/framework/network_test.gd"
## MotorSynchronizer: unauthorized and invalid packets change nothing, cost little and are reported.

# 0x40, the version (1) times 4, the kind.
const MOTION := 0x46
const ACK := 0x47
const OPEN := 0x44
const CLOSE := 0x45

## Offset of the version of the stream format in an OPEN.
const OPEN_VERSION := 5
const VERSION_FAULT := (
	"it has version %d of the %s format, but this peer uses version %d; install the same version of "
	+ "the GA-Godot addon on all peers"
)

## Packets from the server, captured by a client.
var _captured: Array[PackedByteArray] = []


func test_motion_from_a_peer_without_authority() -> void:
	await connect_peers(2, 3)
	await _listen(branches[1])
	# The client sends the server its own packets back, and forged ones.
	for packet in _captured:
		branches[1].api.send_bytes(packet, 1, MultiplayerPeer.TRANSFER_MODE_UNRELIABLE)
	await _bombard(branches[1], branches[0], 300, MOTION)
	await _expect_unmoved(branches[0])
	_expect_rejections(
		branches[0],
		branches[1],
		"Packet rejected: the packet belongs to a stream that was not requested (",
		300 + _captured.size()
	)
	# The other client is not affected.
	await expect_motion(0.3, [branches[2]])
	expect_equal(branches[2].rejections, [] as Array[Array], "rejections by the other client")


func test_damaged_packets_from_the_authority() -> void:
	await connect_peers(1, 3)
	await _listen(branches[1])
	await move(branches[0], SETTLE)
	var random := RandomNumberGenerator.new()
	random.seed = 4
	var sent := 0
	for packet: PackedByteArray in _captured.slice(0, 20):
		# Truncated, damaged, lengthened.
		for variant: PackedByteArray in [
			packet.slice(0, maxi(5, packet.size() / 2)),
			_damaged(packet, random),
			packet + PackedByteArray([1, 2, 3, 4, 5, 6])
		]:
			branches[0].api.send_bytes(
				variant, branches[1].api.get_unique_id(), MultiplayerPeer.TRANSFER_MODE_UNRELIABLE
			)
			sent += 1
	expect_true(sent >= 12, "%d damaged packets are at least 12" % sent)
	await expect_motion(0.4, [branches[1]])
	for body: Node3D in branches[1].synchronizer.get_active_targets():
		expect_true(body.transform.is_finite(), "the transform of %s is finite" % body.name)


func test_acks_and_close_packets_from_an_unsubscribed_peer() -> void:
	await connect_peers(1, 2)
	# A client without a synchronizer.
	var outsider := make_branch("Outsider")
	var server_peer: ENetMultiplayerPeer = branches[0].api.multiplayer_peer
	outsider.join(server_peer.host.get_local_port())
	await wait_until(outsider.is_joined, "the outsider to connect")
	await _bombard(outsider, branches[0], 50, ACK)
	await _bombard(outsider, branches[0], 50, CLOSE)
	await wait_until(func() -> bool: return branches[0].rejections.size() >= 2, "two reports", 3.0)
	var reasons := ""
	for rejection in branches[0].rejections:
		expect_equal(rejection[0], outsider.api.get_unique_id(), "the peer")
		var reason: String = rejection[1]
		reasons += reason
	expect_true(
		(
			reasons.contains("it acknowledges a stream that its sender does not receive")
			and reasons.contains("the close packet is malformed")
		),
		"reasons: %s" % reasons
	)
	await expect_motion(0.3, [branches[1]])


func test_repeated_open_packets_give_one_stream() -> void:
	await connect_peers(1, 40)
	await move(branches[0], SETTLE)
	var before: float = branches[0].synchronizer.get_statistics()["sent_bytes_per_second"]
	for tick in 45:
		for i in 20:
			var open := _envelope(OPEN)
			open[3] = randi_range(0, 255)
			branches[1].api.send_bytes(open, 1, MultiplayerPeer.TRANSFER_MODE_UNRELIABLE)
		await move(branches[0], 1.0 / 60.0)
	var after: float = branches[0].synchronizer.get_statistics()["sent_bytes_per_second"]
	expect_true(
		after < 8.0 * before + 20000.0,
		"the rate of %d bytes per second is not far above that of %d before" % [after, before]
	)
	# The client opens the stream that it replaced again.
	await move(branches[0], 1.0)
	await expect_motion(0.3, [branches[1]])


func test_another_version_is_reported() -> void:
	await connect_peers(1, 1)
	await move(branches[0], 0.3)
	var packet := _envelope(MOTION)
	var own := packet[0] >> 2 & 3
	packet[0] = packet[0] ^ 0x08
	var client := branches[1].api.get_unique_id()
	var fault := VERSION_FAULT % [own ^ 2, "session", own]
	var warning := "a packet of peer %d was rejected: %s." % [client, fault]
	expect_warning("MotorSynchronizer: " + warning)
	branches[1].api.send_bytes(packet, 1)
	await wait_until(func() -> bool: return not branches[0].rejections.is_empty(), "a report")
	expect_equal(
		branches[0].rejections,
		[[client, "Packet rejected: %s (1 since the last report)." % fault]] as Array[Array]
	)
	# It is printed once, however often the peer repeats it.
	for i in 3:
		branches[1].api.send_bytes(packet, 1)
		await wait_until(func() -> bool: return branches[0].rejections.size() > i + 1, "a report")
	expect_equal(branches[0].synchronizer.get_setup_warnings(), PackedStringArray([warning]))


func test_another_stream_version_is_reported() -> void:
	await connect_peers(1, 1)
	var opens: Array[PackedByteArray] = []
	branches[1].api.peer_packet.connect(
		func(_peer: int, packet: PackedByteArray) -> void:
			if packet[0] == OPEN:
				opens.append(packet)
	)
	await wait_until(func() -> bool: return not opens.is_empty(), "the server's OPEN")
	var own := opens[0][OPEN_VERSION]
	var client := branches[1].api.get_unique_id()
	var warning := (
		"MotorSynchronizer: a packet of peer %d was rejected: %s."
		% [client, VERSION_FAULT % [200, "stream", own]]
	)
	expect_warning(warning)
	var packet := opens[0].duplicate()
	packet[OPEN_VERSION] = 200
	branches[1].api.send_bytes(packet, 1)
	await wait_until(func() -> bool: return not branches[0].rejections.is_empty(), "a report")
	await expect_motion(0.3, [branches[1]])


## A transport may give the id of a peer that has left to another one within one frame.
func test_a_peer_that_leaves_and_returns_in_one_frame_starts_anew() -> void:
	await connect_peers(1, 1)
	var links := PackedInt32Array()
	branches[1].api.peer_packet.connect(
		func(_peer: int, packet: PackedByteArray) -> void:
			if packet[0] == OPEN:
				links.append(packet[3])
	)
	await expect_motion(0.2, [branches[1]])
	var before := links.duplicate()
	branches[0].api.peer_disconnected.emit(branches[1].api.get_unique_id())
	await wait_until(func() -> bool: return links.size() > before.size(), "a new request")
	expect_true(not before.has(links[-1]), "the server requests another stream")
	# The client has not left here, and requests the server's stream after a second of silence.
	await move(branches[0], 1.5)
	await expect_motion(0.2, [branches[1]])


func test_packets_of_others_are_ignored() -> void:
	await connect_peers(1, 1)
	var messages := PackedStringArray()
	branches[0].api.peer_packet.connect(
		func(_peer: int, packet: PackedByteArray) -> void:
			if packet[0] == 0x63:
				messages.append(packet.get_string_from_ascii())
	)
	await move(branches[0], 0.4)
	for i in 30:
		branches[1].api.send_bytes(("chat %d" % i).to_ascii_buffer(), 1)
		var other := _envelope(MOTION)
		other[1] = other[1] ^ 1
		branches[1].api.send_bytes(other, 1)
		branches[1].api.send_bytes(PackedByteArray([MOTION]), 1)
	await move(branches[0], 0.2)
	expect_equal(messages.size(), 30, "messages of the game")
	expect_equal(branches[0].synchronizer.get_statistics()["rejected"], 0, "rejected")


## A peer sends a body that it does not own in its own stream.
func test_unauthorized_bodies_of_a_stream_are_ignored() -> void:
	await connect_peers(1, 2)
	var client: int = branches[1].api.get_unique_id()
	# The client sets itself as the authority of both bodies, the server of one.
	branches[0].get_body(1).set_multiplayer_authority(client)
	branches[1].get_body(0).set_multiplayer_authority(client)
	branches[1].get_body(1).set_multiplayer_authority(client)
	await move(branches[1], SETTLE)
	expect_true(distance_from_path(branches[0].get_body(1)) < 0.008, "the client's body is shown")
	expect_equal(branches[0].get_body(0).position, Vector3.ZERO, "position of the server's body")
	expect_equal(
		branches[0].synchronizer.get_statistics()["unauthorized"], 1, "unauthorized bodies"
	)


func test_the_server_cannot_move_bodies_of_clients() -> void:
	for relay: bool in [false, true]:
		await connect_peers(2, 3)
		for branch in branches:
			branch.synchronizer.relay = relay
		# The server takes all bodies for its own, and sends them.
		for branch: NetworkBranch in branches.slice(1):
			for i in 2:
				branch.get_body(i + 1).set_multiplayer_authority(
					branches[i + 1].api.get_unique_id()
				)
		await expect_motion_of_one(0.3)
		for branch: NetworkBranch in branches.slice(1):
			for i in 2:
				expect_equal(branch.get_body(i + 1).position, Vector3.ZERO, "position of a body")
		free_nodes()


## Expects the motion of the server's first body at all clients.
func expect_motion_of_one(seconds: float) -> void:
	await move(branches[0], SETTLE + 0.5)
	var worst := 0.0
	for tick in roundi(seconds * Engine.physics_ticks_per_second):
		await move(branches[0], 1.0 / Engine.physics_ticks_per_second)
		for branch: NetworkBranch in branches.slice(1):
			worst = maxf(worst, distance_from_path(branch.get_body(0)))
	expect_true(worst < 0.008, "%.1f mm from the path are less than 8 mm" % (worst * 1000.0))


## Peers exchange nothing before both have completed the authentication.
func test_peers_that_are_not_authenticated_exchange_nothing() -> void:
	var server := make_branch("Server")
	var client := make_branch("Client")
	var pending: Array[int] = []
	for branch in branches:
		branch.api.auth_timeout = 0.0
		branch.api.auth_callback = func(_peer: int, _data: PackedByteArray) -> void: pass
		branch.add_bodies(2)
	server.api.peer_authenticating.connect(func(peer: int) -> void: pending.append(peer))
	var received := PackedInt32Array()
	for branch in branches:
		branch.api.peer_packet.connect(
			func(peer: int, _packet: PackedByteArray) -> void: received.append(peer)
		)
	client.join(server.host())
	server.start()
	client.start()
	await wait_until(func() -> bool: return not pending.is_empty(), "the client to connect")
	await move(server, 1.0)
	expect_equal(received, PackedInt32Array(), "the senders of packets")
	expect_equal(server.synchronizer.get_statistics()["sent_bytes_per_second"], 0.0, "bytes sent")
	expect_equal(client.get_body(1).position, Vector3.ZERO, "position at the client")
	server.api.complete_auth(pending[0])
	client.api.complete_auth(1)
	await wait_until(client.is_joined, "the client to join")
	await expect_motion(0.3, [client])


## 10,000 invalid packets must take less than 50 ms.
func test_rejecting_is_cheap() -> void:
	await connect_peers(1, 1)
	await move(branches[0], 0.3)
	var packet := _envelope(MOTION)
	packet.resize(200)
	var count := 10000
	var started := Time.get_ticks_usec()
	for i in count:
		branches[0].api.emit_signal(&"peer_packet", branches[1].api.get_unique_id(), packet)
	var milliseconds := (Time.get_ticks_usec() - started) / 1000.0
	expect_equal(branches[0].synchronizer.get_statistics()["rejected"], count, "rejected")
	expect_duration_below(milliseconds, 50.0, "rejecting %d packets" % count)
	await move(branches[0], 0.1)
	expect_equal(branches[0].rejections.size(), 1, "reports")


func _listen(client: NetworkBranch) -> void:
	client.api.peer_packet.connect(
		func(_peer: int, packet: PackedByteArray) -> void:
			if packet[0] == MOTION and _captured.size() < 60:
				_captured.append(packet)
	)
	await move(branches[0], 0.9)
	expect_true(_captured.size() >= 4, "%d captured packets are at least 4" % _captured.size())


## Sends packets with the synchronizer's envelope and random content.
func _bombard(from: NetworkBranch, to: NetworkBranch, count: int, kind: int) -> void:
	var random := RandomNumberGenerator.new()
	random.seed = 8
	for i in count:
		var packet := _envelope(kind)
		for k in random.randi_range(2, 1000):
			packet.append(random.randi_range(0, 255))
		from.api.send_bytes(
			packet, to.api.get_unique_id(), MultiplayerPeer.TRANSFER_MODE_UNRELIABLE
		)
		if i % 50 == 49:
			await move(branches[0], 0.02)
	await move(branches[0], 0.1)


## The four bytes of an envelope; 255 is the number of a link that no peer has.
func _envelope(kind: int) -> PackedByteArray:
	return PackedByteArray([kind, 0xa1, 0xc6, 255])


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
	branch: NetworkBranch, offender: NetworkBranch, prefix: String, min_count: int
) -> void:
	var peer: int = offender.api.get_unique_id()
	var statistics := branch.synchronizer.get_statistics()
	var peers: Dictionary = statistics["peers"]
	var offender_statistics: Dictionary = peers[peer]
	var rejected: int = offender_statistics["rejected"]
	expect_true(
		rejected >= min_count * 9 / 10, "%d of %d packets were rejected" % [rejected, min_count]
	)
	expect_equal(statistics["rejected"], rejected, "total of rejected packets")
	expect_true(
		branch.rejections.size() >= 1 and branch.rejections.size() <= 8,
		"%d reports are from 1 to 8" % branch.rejections.size()
	)
	for rejection in branch.rejections:
		expect_equal(rejection[0], peer, "the peer")
		var reason: String = rejection[1]
		expect_true(reason.begins_with(prefix), "reason: %s" % reason)
