extends "res://tests/framework/network_test.gd"
## MotorSynchronizer: replication over ENet and WebSocket, to peers that join and leave.


func test_motion_over_enet() -> void:
	await connect_peers(2, 5)
	await expect_motion(0.8, [branches[1], branches[2]])
	_expect_no_rejections()


func test_motion_over_websocket() -> void:
	await connect_peers(1, 5, true)
	await expect_motion(0.6, [branches[1]])
	_expect_no_rejections()


func test_rotation_and_scale_arrive() -> void:
	await connect_peers(1, 1)
	var sent := Transform3D(
		Basis(Vector3(1, 2, 3).normalized(), 2.0).scaled(Vector3.ONE * 1.75), Vector3(4, 5, 6)
	)
	await move(branches[0], 0.6, func(_name: StringName, _time: float) -> Transform3D: return sent)
	var shown := branches[1].get_body(0).transform
	expect_vector_near(
		shown.origin, sent.origin, branches[0].synchronizer.position_tolerance, "position"
	)
	expect_transform_near(
		Transform3D(shown.basis), Transform3D(sent.basis), 0.05, "rotation and scale"
	)


func test_resting_bodies_keep_their_places() -> void:
	await connect_peers(1, 3)
	await move(branches[0], 0.5)
	await tree.create_timer(SETTLE).timeout
	for i in 3:
		var tolerance := branches[0].synchronizer.position_tolerance
		expect_vector_near(
			branches[1].get_body(i).position,
			branches[0].get_body(i).position,
			tolerance,
			"body %d" % i
		)
		# A local change is overwritten.
		branches[1].get_body(i).position += Vector3.ONE
	await wait_frames(3)
	for i in 3:
		expect_vector_near(
			branches[1].get_body(i).position,
			branches[0].get_body(i).position,
			0.01,
			"body %d after a local change" % i
		)


func test_late_peer_gets_a_snapshot() -> void:
	await connect_peers(1, 4)
	await move(branches[0], 0.5)
	var late := make_branch("Late")
	late.add_bodies(4)
	late.start()
	var server_peer: ENetMultiplayerPeer = branches[0].api.multiplayer_peer
	late.join(server_peer.host.get_local_port())
	await wait_until(late.is_joined, "the late peer to connect")
	await expect_motion(0.5, [branches[1], late])
	_expect_no_rejections()


func test_late_synchronizer_gets_a_snapshot() -> void:
	var port := make_branch("Server").host()
	var client := make_branch("Client0")
	client.join(port)
	branches[0].add_bodies(2)
	client.add_bodies(2)
	# The receiver starts long before the sender, then restarts.
	client.start()
	await wait_until(client.is_joined, "the peer to connect")
	await tree.create_timer(0.3).timeout
	branches[0].start()
	await expect_motion(0.25, [client])
	client.world.remove_child(client.synchronizer)
	var place := client.get_body(0).position
	await move(branches[0], 0.3)
	expect_equal(
		client.get_body(0).position, place, "the position while the node is not in the tree"
	)
	client.world.add_child(client.synchronizer)
	await expect_motion(0.25, [client])
	# The sender restarts.
	branches[0].world.remove_child(branches[0].synchronizer)
	await tree.create_timer(0.2).timeout
	branches[0].world.add_child(branches[0].synchronizer)
	await expect_motion(0.25, [client])
	_expect_no_rejections()


func test_peers_leave_without_an_error() -> void:
	await connect_peers(3, 2)
	await move(branches[0], 0.5)
	branches[1].leave()
	branches[0].api.disconnect_peer(branches[2].api.get_unique_id())
	await expect_motion(0.4, [branches[3]])
	var peers: Dictionary = branches[0].synchronizer.get_statistics()["peers"]
	expect_equal(
		peers.keys(), [branches[3].api.get_unique_id()], "peers in the statistics of the server"
	)


func test_server_restarts() -> void:
	await connect_peers(1, 2)
	await move(branches[0], 0.5)
	branches[0].leave()
	await wait_until(func() -> bool: return not branches[1].is_joined(), "the client to notice")
	await move(branches[0], 0.2)
	var port := branches[0].host()
	branches[1].join(port)
	await wait_until(branches[1].is_joined, "the peers to reconnect")
	await expect_motion(0.4, [branches[1]])


func test_teleport_is_not_interpolated() -> void:
	await connect_peers(1, 1)
	await move(branches[0], SETTLE)
	var far := Vector3(1000, 0, 0)
	var between := 0
	for tick in 50:
		var offset := far if tick >= 10 else Vector3.ZERO
		await move(
			branches[0],
			1.0 / 60.0,
			func(body_name: StringName, now: float) -> Transform3D:
				if tick == 10:
					branches[0].synchronizer.teleport(branches[0].get_body(0))
				return Transform3D(Basis.IDENTITY, offset) * default_pose(body_name, now)
		)
		var x := branches[1].get_body(0).position.x
		between += int(x > 2.0 and x < 998.0)
	expect_equal(between, 0, "frames between the two positions")
	expect_true(branches[1].get_body(0).position.x > 998.0, "the body has arrived")


func test_motion_continues_after_a_pause() -> void:
	await connect_peers(1, 2)
	await move(branches[0], SETTLE)
	for paused in branches:
		paused.root.process_mode = Node.PROCESS_MODE_DISABLED
		await tree.create_timer(0.3).timeout
		paused.root.process_mode = Node.PROCESS_MODE_INHERIT
		await expect_motion(0.2, [branches[1]])
	tree.paused = true
	await tree.create_timer(0.3, true).timeout
	tree.paused = false
	await expect_motion(0.2, [branches[1]])
	_expect_no_rejections()


func test_without_a_network_nothing_is_sent() -> void:
	var branch := make_branch("Alone")
	branch.add_bodies(2)
	branch.start()
	await move(branch, 0.2)
	expect_equal(branch.changes, PackedStringArray(["+Body0", "+Body1"]), "targets")
	var statistics := branch.synchronizer.get_statistics()
	expect_equal(statistics["bytes_per_second"], 0.0, "bytes per second")
	expect_equal(statistics["peers"], {}, "peers")
	branch.synchronizer.teleport(branch.get_body(0))


func test_statistics() -> void:
	await connect_peers(1, 3)
	await move(branches[0], 1.1)
	var sender := branches[0].synchronizer.get_statistics()
	var receiver := branches[1].synchronizer.get_statistics()
	var sent: float = sender["sent_bytes_per_second"]
	var received: float = receiver["received_bytes_per_second"]
	expect_true(
		sent > 100.0 and received > 100.0,
		"%s bytes sent and %s received per second are more than 100" % [sent, received]
	)
	expect_near(received / sent, 1.0, 0.4, "ratio of received to sent bytes")
	var total: float = sender["bytes_per_second"]
	var acks: float = sender["received_bytes_per_second"]
	expect_near(total, sent + acks, 1e-6, "total of both directions")
	var packets: float = receiver["packets_per_second"]
	expect_true(
		packets >= 5.0 and packets < 200.0, "%s packets per second are from 5 to 200" % packets
	)
	var delay: float = receiver["playback_delay"]
	expect_true(
		delay > 0.0 and delay < 0.6, "a playback delay of %s s is between 0 and 0.6 s" % delay
	)
	var peers: Dictionary = receiver["peers"]
	expect_equal(peers.keys(), [1], "peers")
	var server: Dictionary = peers[1]
	expect_equal(server["received_bytes_per_second"], received, "bytes per second from the server")
	expect_equal(receiver["rejected"], 0, "rejected")
	# ENet itself drops a packet now and then when the round trips of reliable ones vary.
	expect_near(sender["loss"] as float, 0.0, 0.07, "loss over loopback")
	var late: int = receiver["late"]
	expect_true(late <= 2, "%d late windows are at most 2" % late)
	var round_trip: float = sender["round_trip"]
	expect_true(
		round_trip > 0.0 and round_trip < 0.5,
		"a round trip of %s s is between 0 and 0.5 s" % round_trip
	)


func test_monitors() -> void:
	var monitors := [
		"ga_godot/Motors/bytes_per_second",
		"ga_godot/Motors 2/bytes_per_second",
		"ga_godot/Motors 2/loss"
	]
	await connect_peers(1, 1)
	await move(branches[0], 0.6)
	for monitor: StringName in monitors:
		expect_true(Performance.has_custom_monitor(monitor), "the monitor %s exists" % monitor)
	var bytes: float = Performance.get_custom_monitor(&"ga_godot/Motors/bytes_per_second")
	expect_true(bytes > 0.0, "the monitor of %s bytes per second is positive" % bytes)
	for branch in branches:
		branch.world.remove_child(branch.synchronizer)
	for monitor: StringName in monitors:
		expect_true(
			not Performance.has_custom_monitor(monitor), "the monitor %s is removed" % monitor
		)


func _expect_no_rejections() -> void:
	for branch in branches:
		expect_equal(branch.rejections, [] as Array[Array], "rejections by %s" % branch.root.name)


func test_media_time_is_the_shown_time_on_the_senders_clock() -> void:
	await connect_peers(1, 1)
	expect_near(branches[1].synchronizer.get_media_time(1), 0.0, 0.0, "media time before playback")
	for tick in 120:
		await move(branches[0], 1.0 / Engine.physics_ticks_per_second)
		if branches[1].synchronizer.get_media_time(1) > 0.1:
			break
	var errors := PackedFloat32Array()
	for tick in 30:
		await move(branches[0], 1.0 / Engine.physics_ticks_per_second)
		var shown := branches[1].synchronizer.get_media_time(1)
		var delay := branches[0].synchronizer.get_media_time(1) - shown
		expect_true(
			shown > 0.0 and delay > 0.0 and delay < 0.5,
			"the media time of %.3f s is up to 0.5 s behind the sender: %.3f s" % [shown, delay]
		)
		# move() is one tick ahead of the pose that the synchronizer sampled last.
		var then := default_pose(
			branches[0].get_body(0).name, time - delay - 1.0 / Engine.physics_ticks_per_second
		)
		errors.append(branches[1].get_body(0).position.distance_to(then.origin))
	# A loaded machine may skip ticks or frames between the two readings, but rarely.
	errors.sort()
	expect_true(
		errors[15] < 0.008, "the median error of %.1f mm is below 8 mm" % (errors[15] * 1000.0)
	)
	expect_near(
		branches[1].synchronizer.get_media_time(77), 0.0, 0.0, "media time of an unknown peer"
	)
