@tool
@abstract
extends EditorPlugin
## A person in the editor who does one step after another, some frames apart, so that each has shown
## its effects before the next. Each mistake prints a line that begins with [probe] FAIL.

const Hands := preload("res://tests/framework/hands.gd")

const FIRST_FRAMES := 40

var settling_frames := 6

var _steps: Array[Callable] = []
var _frames := -FIRST_FRAMES
var _step := 0
var _said := 0

## In their order; the last is _end.
@abstract func get_steps() -> Array[Callable]


func _enter_tree() -> void:
	_steps = get_steps()


func _process(_delta: float) -> void:
	if (
		DisplayServer.get_name() == "headless"
		or EditorInterface.get_resource_filesystem().is_scanning()
	):
		return
	_frames += 1
	if _frames >= settling_frames and _step < _steps.size():
		_frames = 0
		_step += 1
		_steps[_step - 1].call()


func _end() -> void:
	print("[probe] %d expectations" % _said)
	print("[probe] done")
	get_tree().quit()


func _expect(got: Variant, wanted: Variant, what: String) -> void:
	_said += 1
	if typeof(got) != typeof(wanted) or got != wanted:
		print("[probe] FAIL %s: %s, expected %s" % [what, got, wanted])


## The value of a user argument that begins so, empty if it is not given.
func _option(option: String) -> String:
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with(option):
			return argument.trim_prefix(option)
	return ""
