extends "base.gd"
## A projectile "P" flies and ends by free_target. Then a body "Q" is freed and another of the same
## name spawned on another lane, in the same tick; and a body "R" and another, in the next tick.

const SPEED_OF_PROJECTILE := 40.0
const SPEED_OF_BODY := 10.0
const FLIGHT := 0.5
const LANE := 5.0

## [time, what the server does]; the first is due next.
var _plan: Array[Array] = [
	[1.5, _spawn.bind("P", "P", 0.0)],
	[1.5 + FLIGHT, _end_projectile],
	[2.6, _spawn.bind("Q", "Q1", 0.0)],
	[3.2, _replace_body],
	[3.2, _spawn.bind("R", "R1", 0.0)],
	[3.8, _free_body],
	[3.8, _spawn.bind("R", "R2", LANE)],
]
var _spawner := MultiplayerSpawner.new()


func _build() -> void:
	_spawner.name = &"Spawner"
	_spawner.spawn_function = _make
	world.add_child(_spawner)
	_spawner.spawn_path = ^".."
	if synchronizer.has_signal(&"target_ended"):
		synchronizer.connect(&"target_ended", _on_target_ended)
	else:
		print("MISSING target_ended")


func _tick(_delta: float) -> void:
	if not is_server or _plan.is_empty():
		return
	var due: float = _plan[0][0]
	if time > due:
		var action: Callable = _plan.pop_front()[1]
		action.call()


## Each projectile flies along its lane; y and z keep.
func _move(body: Node, delta: float) -> void:
	(body as Node3D).position.x += speed_of(body) * delta


func _report(report: Dictionary) -> void:
	var left: Array[String] = []
	for body: Node in get_tree().get_nodes_in_group(&"recorded"):
		left.append(body.get_meta(&"label"))
	report["left"] = left


func _spawn(body_name: String, label: String, lane: float) -> void:
	_spawner.spawn({"name": body_name, "label": label, "lane": lane})


func _make(data: Dictionary) -> Node:
	var body := Node3D.new()
	var label: String = data["label"]
	body.name = data["name"]
	prepare_body(body, label, SPEED_OF_PROJECTILE if label == "P" else SPEED_OF_BODY)
	if is_server:
		body.position.z = data["lane"]
	return body


func _end_projectile() -> void:
	var body := world.get_node(^"P") as Node3D
	body.remove_from_group(MOVING)
	recorder.mark("end")
	if synchronizer.has_method(&"free_target"):
		synchronizer.call(&"free_target", body)
		recorder.mark("hidden" if not body.is_visible_in_tree() else "shown after its end")
	else:
		print("MISSING free_target")
		body.queue_free()


## Without a tick between the two.
func _replace_body() -> void:
	world.get_node(^"Q").free()
	_spawn("Q", "Q2", LANE)


func _free_body() -> void:
	world.get_node(^"R").queue_free()


func _on_target_ended(body: Node) -> void:
	recorder.mark("ended %s %.4f" % [body.get_meta(&"label"), (body as Node3D).global_position.x])
