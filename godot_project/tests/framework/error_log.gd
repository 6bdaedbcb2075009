extends Logger
## Records the errors and warnings of the engine, the extension and scripts while tests run, from
## any thread, and compares them with those that a test expects.

## The prefix of warnings, as in the engine's output.
const WARNING := "WARNING: "

var _mutex := Mutex.new()
var _expected: Array[String] = []
var _unexpected := PackedStringArray()


func _log_error(
	function: String,
	file: String,
	line: int,
	code: String,
	rationale: String,
	_editor_notify: bool,
	error_type: int,
	script_backtraces: Array[ScriptBacktrace]
) -> void:
	var message := code if rationale.is_empty() else rationale
	if error_type == Logger.ERROR_TYPE_WARNING:
		message = WARNING + message
	_mutex.lock()
	var index := _find_expected(message)
	if index >= 0:
		_expected.remove_at(index)
	else:
		_unexpected.append(
			(
				"unexpected error: %s\n      at %s (%s:%d)%s"
				% [message, function, file, line, _script_line(script_backtraces)]
			)
		)
	_mutex.unlock()


## Expects one error with exactly this message, or, if it ends in "...", one that begins with it;
## for a warning, prefixed with [constant WARNING].
func expect(message: String) -> void:
	_mutex.lock()
	_expected.append(message)
	_mutex.unlock()


## The unexpected messages, and the expected ones that were not logged, since the last call.
func take_faults() -> PackedStringArray:
	_mutex.lock()
	var faults := _unexpected.duplicate()
	for message in _expected:
		faults.append("expected error was not logged: %s" % message)
	_expected.clear()
	_unexpected.clear()
	_mutex.unlock()
	return faults


func _find_expected(message: String) -> int:
	for i in _expected.size():
		var beginning := _expected[i].trim_suffix("...")
		if (
			message == _expected[i]
			or (beginning != _expected[i] and message.begins_with(beginning))
		):
			return i
	return -1


func _script_line(backtraces: Array[ScriptBacktrace]) -> String:
	for backtrace in backtraces:
		if backtrace.get_frame_count() > 0:
			return (
				", called from %s:%d" % [backtrace.get_frame_file(0), backtrace.get_frame_line(0)]
			)
	return ""
