@tool
@abstract
extends EditorPlugin
## Runs steps in the editor, some frames apart, so that each has taken effect before the next. Each
## failure prints a line that starts with [probe] FAIL.

const Hands := preload("res://tests/framework/hands.gd")

const FIRST_FRAMES := 40

var settling_frames := 6

var _steps: Array[Callable] = []
var _frames := -FIRST_FRAMES
var _step := 0
var _expectations := 0

## The steps in order; the last one is _end.
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
	print("[probe] %d expectations" % _expectations)
	print("[probe] done")
	get_tree().quit()


func _expect(got: Variant, wanted: Variant, what: String) -> void:
	_expectations += 1
	if typeof(got) != typeof(wanted) or got != wanted:
		print("[probe] FAIL %s: %s, expected %s" % [what, got, wanted])


## The rest of the user argument that starts with `option`; empty if there is none.
func _option(option: String) -> String:
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with(option):
			return argument.trim_prefix(option)
	return ""
