extends "base.gd"
## The server has `bodies` bodies, a client the first `client_bodies` of them. Those move, and
## `moving` in total; `shown` of them are recorded. With `own_synchronizers`, each body has a
## MotorSynchronizer of its own, in a scene of its own.


func _build() -> void:
	var count := int(number("bodies"))
	if not is_server:
		count = int(number("client_bodies", number("bodies")))
	for i: int in count:
		var body := Node3D.new()
		body.position.z = 0.5 * i
		var parent: Node = world
		if flag("own_synchronizers"):
			parent = Node3D.new()
			parent.name = "Scene%d" % i
			world.add_child(parent)
		add_body(body, "A" if i == 0 else "A%d" % i, parent, SPEED if i < number("moving") else 0.0)
		if i >= number("shown", 3.0):
			body.remove_from_group(&"recorded")
		if flag("own_synchronizers"):
			_add_synchronizer(body, parent, i == 0)


## Different motion of each body: packets cost what they do in a game.
func _move(body: Node, delta: float) -> void:
	var node := body as Node3D
	var x := node.position.x + SPEED * delta
	var phase := node.position.z
	var turn := Basis(Vector3.UP, 0.5 * sin(x + phase)) * Basis(Vector3.RIGHT, cos(0.7 * x))
	var y := 0.3 * sin(1.3 * x + phase) + 0.2 * sin(2.9 * x + 2.0 * phase)
	node.transform = Transform3D(turn, Vector3(x, y, node.position.z))


func _add_synchronizer(body: Node, parent: Node, is_first: bool) -> void:
	body.remove_from_group(&"targets")
	var own := synchronizer if is_first else new_synchronizer()
	own.target_group = &""
	own.targets = [NodePath("../" + body.name)] as Array[NodePath]
	parent.add_child(own)
