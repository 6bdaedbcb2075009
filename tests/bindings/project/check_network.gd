## Callables and signals from C++, groups, and the multiplayer classes.
extends Checks


func check_signals_to_methods_that_are_not_bound() -> void:
	var node := SampleNode.new()
	var source := Node.new()
	source.add_user_signal("announced", [{"name": "what", "type": TYPE_STRING}])
	node.overhear(source, &"announced")
	same(source.is_connected("announced", node.private_callables()[0]), true)
	source.emit_signal("announced", "loudly")
	same(node.get_log()[-1], "loudly overheard")
	node.stop_overhearing(source, &"announced")
	same(source.get_signal_connection_list("announced").size(), 0)
	source.emit_signal("announced", "not connected")
	same(node.get_log()[-1], "loudly overheard")
	node.overhear(source, &"announced")
	node.free()
	same(source.get_signal_connection_list("announced").size(), 0)
	source.emit_signal("announced", "after disconnecting")
	source.free()


func check_callables_of_methods_that_are_not_bound() -> void:
	var node := SampleNode.new()
	var other := SampleNode.new()
	var callables: Array = node.private_callables()
	var count: Callable = callables[1]
	var add: Callable = callables[2]
	same(
		[node.has_method("count"), node.has_method("overheard"), node.has_method("add")],
		[false, false, false]
	)
	same([count.is_custom(), count.get_argument_count(), add.get_argument_count()], [true, 1, 2])
	same([add.call(1.5, 2), add.callv([1, 2]), add.bind(4).call(0.5)], [3.5, 3.0, 4.5])
	same(callables == node.private_callables(), true)
	same(count == add, false)
	same(count == other.private_callables()[1], false)
	same(count.hash() == node.private_callables()[1].hash(), true)
	var seen: Dictionary = {count: "count", add: "add"}
	same(seen[node.private_callables()[1]], "count")
	same([count.call(node), count.call(null)], [0, -1])
	var freed := Node.new()
	freed.free()
	same(count.call(freed), -1)
	same([count.callv([]), count.callv([node, node])], [null, null])
	same(node.get_log().count("counted"), 3)
	same(count.get_object(), node)
	var values := SampleValues.new()
	same([values.echo(count), values.type_of(count)], [count, "Callable"])
	node.free()
	other.free()


func check_groups() -> void:
	var node := SampleNode.new()
	tree.root.add_child(node)
	for mark: String in ["A", "B"]:
		var member := Marker3D.new()
		member.name = mark
		member.add_to_group(&"marks")
		node.add_child(member)
	same(node.names_in_group(&"marks"), PackedStringArray(["A", "B"]))
	same(node.names_in_group(&"nothing"), PackedStringArray())
	node.free()


func check_multiplayer() -> void:
	var node := SampleNode.new()
	tree.root.add_child(node)
	same(
		node.describe_multiplayer(),
		["SceneMultiplayer", ^"/root", 1, 0, MultiplayerPeer.CONNECTION_CONNECTED]
	)
	var branch := Node.new()
	branch.name = "Branch"
	tree.root.add_child(branch)
	tree.set_multiplayer(SceneMultiplayer.new(), ^"/root/Branch")
	node.reparent(branch)
	same(node.describe_multiplayer()[1], ^"/root/Branch")
	expect_error("Trying to send an empty raw packet.")
	same(node.send(PackedByteArray(), 2), ERR_INVALID_DATA)
	tree.set_multiplayer(null, ^"/root/Branch")
	branch.free()


func check_replication_configs() -> void:
	var node := SampleNode.new()
	var synchronizer := MultiplayerSynchronizer.new()
	synchronizer.replication_config = SceneReplicationConfig.new()
	synchronizer.replication_config.add_property(^"A/B:position:x")
	synchronizer.replication_config.add_property(^".:rotation")
	same(node.sent_properties(synchronizer), PackedStringArray(["position:x", "rotation"]))
	synchronizer.free()
	node.free()
