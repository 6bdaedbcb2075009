extends "motion.gd"
## The server (with `client_holds` the client) stops for `hold_seconds` from `hold_at` on: `hold`
## "block" blocks the process, "pause" pauses the tree. `steps` limits the physics steps of each
## frame of the server: with fewer frames than ticks, its physics runs slow.

var _hold_end := -1.0
var _has_held := false


func _build() -> void:
	if is_server and config.has("steps"):
		Engine.max_physics_steps_per_frame = int(number("steps"))
	super._build()


func _tick(_delta: float) -> void:
	if is_server == flag("client_holds") or _has_held or not config.has("hold"):
		return
	if time < number("hold_at"):
		return
	_has_held = true
	recorder.mark("hold_begin")
	if text("hold") == "block":
		OS.delay_msec(int(1000.0 * number("hold_seconds")))
		recorder.mark("hold_end")
	else:
		_hold_end = time + number("hold_seconds")
		get_tree().paused = true


func _frame(_delta: float) -> void:
	if get_tree().paused and time >= _hold_end:
		get_tree().paused = false
		recorder.mark("hold_end")
