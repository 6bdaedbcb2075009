extends "motion.gd"
## The server's clock stops or runs slow. `hold` names how it stops: "block" blocks the process,
## "pause" pauses the tree, for `hold_seconds` from `hold_at` on. `steps` limits the physics steps
## of each frame: with fewer frames than ticks, physics runs slow.

var _hold_end := -1.0
var _has_held := false


func _build() -> void:
	if is_server and config.has("steps"):
		Engine.max_physics_steps_per_frame = int(number("steps"))
	super._build()


func _tick(_delta: float) -> void:
	if not is_server or _has_held or not config.has("hold") or time < number("hold_at"):
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
