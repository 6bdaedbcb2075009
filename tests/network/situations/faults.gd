extends "base.gd"
## Faults of a scene that only show at run time, by `fault`: "name" (a target whose name the engine
## made up), "absent" (a body of the server without a node here), "owner" (an avatar whose owner is
## not connected to this client: `server_relay` is false).


func _build() -> void:
	add_body(Node3D.new(), "A", world)
	match text("fault"):
		"name":
			var body := Node3D.new()
			prepare_body(body, "B")
			world.add_child(body)
		"absent":
			if is_server:
				add_body(Node3D.new(), "OnlyHere", world)
		"owner":
			add_body(Node3D.new(), "B", world)


func _begin() -> void:
	if text("fault") == "owner":
		world.get_node(^"B").set_multiplayer_authority(ids[1])
