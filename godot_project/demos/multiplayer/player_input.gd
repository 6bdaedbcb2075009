extends Node
## Sends the input of the player to the server, from keyboard and mouse or from a script.

const Session := preload("session.gd")

## Seconds between two steering messages while a key is held.
const SEND_PAUSE := 0.05
## Seconds between two steering messages while no key is held, which serve as a heartbeat.
const IDLE_PAUSE := 0.5
## Seconds of frequent messages after the keys are released.
const SEND_AFTER := 0.3
## Rate of the circle in radians per second.
const CIRCLE_RATE := 0.9
## Seconds between two actions of a scripted player.
const ACTION_INTERVAL := 1.0

## Azimuth of the camera in radians.
var yaw := 0.0

var _session: Session
var _autopilot: String
var _seconds := 0.0
var _sent_at := -IDLE_PAUSE
var _next_action := ACTION_INTERVAL
var _action_count := 0
## Time until which a zero direction is sent often, in case messages get lost.
var _send_until := 0.0
var _wants_jump := false


func _init(session: Session, autopilot: String) -> void:
	_session = session
	_autopilot = autopilot


func _process(delta: float) -> void:
	_seconds += delta
	if _seconds >= _next_action:
		_next_action += ACTION_INTERVAL
		_run_action()
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


## Requests to kick a cube.
func kick(cube: int, direction: Vector3) -> void:
	_session.kick.rpc_id(1, cube, direction)


## Whether a script controls the player.
func is_scripted() -> bool:
	return _autopilot != "none"


func _run_action() -> void:
	_action_count += 1
	if _autopilot == "kick":
		kick(0, Vector3(1.0, 0.0, 0.4))
	if _autopilot != "settings":
		return
	match _action_count:
		1:
			_session.request_tuning.rpc_id(1, 0.02, MultivectorLerp.SCREW)
		2:
			_session.request_method.rpc_id(1, "synchronizer")
		3:
			_session.request_tuning.rpc_id(1, 0.002, MultivectorLerp.LINEAR)
		4:
			_session.request_method.rpc_id(1, "motors")
		5:
			_session.request_tuning.rpc_id(1, 0.005, MultivectorLerp.SEPARATE)


func _get_drive() -> Vector2:
	if _autopilot == "circle":
		return Vector2.from_angle(_seconds * CIRCLE_RATE)
	var direction := Vector2(
		_held(KEY_D, KEY_RIGHT) - _held(KEY_A, KEY_LEFT),
		_held(KEY_S, KEY_DOWN) - _held(KEY_W, KEY_UP)
	)
	return direction.limit_length(1.0).rotated(-yaw)


func _held(key: Key, other: Key) -> float:
	return (
		1.0 if Input.is_physical_key_pressed(key) or Input.is_physical_key_pressed(other) else 0.0
	)
