extends "base.gd"
## Bodies of the class `node` (Node3D) that the server moves in straight lines, at `speed`. `bodies`
## of them exist on every peer.


func _build() -> void:
	for i: int in int(number("bodies", 1.0)):
		var body := new_body()
		add_body(body, "A" if i == 0 else "A%d" % i, world, number("speed", SPEED))
		if body is Node3D:
			(body as Node3D).position.z = i


func new_body() -> Node:
	match text("node"):
		"AnimatableBody3D":
			var body := AnimatableBody3D.new()
			var shape := CollisionShape3D.new()
			shape.shape = BoxShape3D.new()
			body.add_child(shape)
			return body
		"Node2D":
			return Node2D.new()
		_:
			return Node3D.new()
