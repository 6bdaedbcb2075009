extends "base.gd"
## The ball changes its owner: client 1 grabs it from the server and throws it back; client 2
## watches. With `agreed`, who gives the ball tells where it is; otherwise who takes it moves it on
## from where it sees it.

const GRAB_AT := 2.0
const THROW_AT := 3.5

var _ball := Node3D.new()
var _has_given := false


func _build() -> void:
	add_body(_ball, "A", world)


func _tick(_delta: float) -> void:
	if _has_given or not (is_server or index == 1):
		return
	if time > (GRAB_AT if is_server else THROW_AT):
		_has_given = true
		_hand_over.rpc(1 if is_server else 0, _ball.position.x, _wall())


@rpc("any_peer", "call_local", "reliable")
func _hand_over(taker: int, x: float, at: float) -> void:
	recorder.mark("grab" if taker == 1 else "throw")
	_ball.set_multiplayer_authority(ids[taker])
	if taker == index and flag("agreed"):
		_ball.position.x = x + SPEED * (_wall() - at)


## A clock that all processes share, in seconds.
func _wall() -> float:
	return Time.get_unix_time_from_system()
