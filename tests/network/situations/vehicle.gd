extends "base.gd"
## A walker boards a moving car and leaves it; an RPC tells every peer to change its parent.

const BOARD_AT := 2.0
const LEAVE_AT := 3.5
const CAR_SPEED := 4.0

var _car := Node3D.new()
var _walker := Node3D.new()
var _changes := 0


func _build() -> void:
	add_body(_car, "Car", world, CAR_SPEED)
	_walker.position.z = 1.0
	add_body(_walker, "A", world)


func _tick(_delta: float) -> void:
	if is_server and time > [BOARD_AT, LEAVE_AT, INF][_changes]:
		_changes += 1
		_change_parent.rpc(_changes == 1)


## On the car, the walker stands.
func _move(body: Node, delta: float) -> void:
	if body == _car:
		super._move(body, delta)
	elif _walker.get_parent() == world:
		_walker.position.x += SPEED * delta


@rpc("authority", "call_local", "reliable")
func _change_parent(boards: bool) -> void:
	recorder.mark("board" if boards else "leave")
	_walker.reparent(_car if boards else world)
