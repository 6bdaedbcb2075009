extends "base.gd"
## Each client owns and moves an avatar, which all others see.


func _build() -> void:
	for i: int in int(number("clients")):
		var avatar := Node3D.new()
		avatar.position.z = i + 1.0
		add_body(avatar, "A%d" % (i + 1), world)


func _begin() -> void:
	for i: int in int(number("clients")):
		world.get_node("A%d" % (i + 1)).set_multiplayer_authority(ids[i + 1])
