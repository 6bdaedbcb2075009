extends Node
## What the player of a client wants: keys and the mouse, or a script; sent to the server.

const Session := preload("session.gd")

## Seconds between two messages about the direction while a key is held.
const SEND_PAUSE := 0.05
## The same while nothing is held: a sign of life.
const IDLE_PAUSE := 0.5
## Seconds for which the direction is still sent after the keys are released.
const SEND_AFTER := 0.3
const CIRCLE_TURN := 0.9
## Seconds between two acts of a scripted player.
const ACT_PAUSE := 1.0

## Direction in which the camera looks, seen from above.
var yaw := 0.0

var _session: Session
var _autopilot: String
var _seconds := 0.0
var _sent_at := -IDLE_PAUSE
var _next_act := ACT_PAUSE
var _acts := 0
## Until then the direction is sent even if it is none: a message may be lost.
var _send_until := 0.0
var _wants_jump := false


func _init(session: Session, autopilot: String) -> void:
	_session = session
	_autopilot = autopilot


func _process(delta: float) -> void:
	_seconds += delta
	if _seconds >= _next_act:
		_next_act += ACT_PAUSE
		_act()
	var drive := _get_drive()
	if drive != Vector2.ZERO or _wants_jump:
		_send_until = _seconds + SEND_AFTER
	if _seconds < _sent_at + (SEND_PAUSE if _seconds <= _send_until else IDLE_PAUSE):
		return
	_sent_at = _seconds
	_session.steer.rpc_id(1, drive, _wants_jump)
	_wants_jump = false


func _unhandled_key_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if key.pressed and not key.echo and key.physical_keycode == KEY_SPACE:
		_wants_jump = true


## Asks the server to kick a cube.
func kick(cube: int, direction: Vector3) -> void:
	_session.kick.rpc_id(1, cube, direction)


## True if nobody sits at this client.
func is_scripted() -> bool:
	return _autopilot != "none"


func _act() -> void:
	_acts += 1
	if _autopilot == "kick":
		kick(0, Vector3(1.0, 0.0, 0.4))
	if _autopilot != "fiddle":
		return
	match _acts:
		1:
			_session.want_tuning.rpc_id(1, 0.02, MultivectorLerp.SCREW)
		2:
			_session.want_method.rpc_id(1, "synchronizer")
		3:
			_session.want_tuning.rpc_id(1, 0.002, MultivectorLerp.LINEAR)
		4:
			_session.want_method.rpc_id(1, "motors")
		5:
			_session.want_tuning.rpc_id(1, 0.005, MultivectorLerp.SEPARATE)


func _get_drive() -> Vector2:
	if _autopilot == "circle":
		return Vector2.from_angle(_seconds * CIRCLE_TURN)
	var wish := Vector2(
		_held(KEY_D, KEY_RIGHT) - _held(KEY_A, KEY_LEFT),
		_held(KEY_S, KEY_DOWN) - _held(KEY_W, KEY_UP)
	)
	return wish.limit_length(1.0).rotated(-yaw)


func _held(key: Key, other: Key) -> float:
	return (
		1.0 if Input.is_physical_key_pressed(key) or Input.is_physical_key_pressed(other) else 0.0
	)
