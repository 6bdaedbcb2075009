extends Node
## Runs all tests in res://tests and quits, with exit code 0 only if all tests ran and passed. The
## last line is `[engine] N passed, N failed`.

const Emulation := preload("res://tests/framework/emulation.gd")
const ErrorLog := preload("res://tests/framework/error_log.gd")
const Filter := preload("res://tests/framework/test_filter.gd")
const TestCase := preload("res://tests/framework/test_case.gd")
const Watchdog := preload("res://tests/framework/watchdog.gd")

const FOLDER := "res://tests"
## Seconds until a test fails; seconds until a test that blocks the main thread ends the process. An
## emulator multiplies both.
const TEST_LIMIT := 60.0
const BLOCK_LIMIT := 90.0

## Which tests to run, see [method Filter.selects]; empty for all.
var argument := ""

var _log := ErrorLog.new()
var _watchdog := Watchdog.new()
var _found := 0
var _passed := 0
var _failed := 0
var _skipped := PackedStringArray()
var _test_finished := false


func _ready() -> void:
	OS.add_logger(_log)
	_run_all.call_deferred()


func _run_all() -> void:
	for file in DirAccess.get_files_at(FOLDER):
		if (
			file.begins_with("test_")
			and file.ends_with(".gd")
			and Filter.may_select_from(argument, file)
		):
			await _run_file(file)
	_watchdog.stop()
	for fault in _log.take_faults():
		_failed += 1
		print("FAIL outside of any test: %s" % fault)
	OS.remove_logger(_log)
	if _found == 0:
		print('FAIL no test matches "%s"' % argument)
	var complete := _found > 0 and _passed == _found and _failed == 0
	if _passed + _failed < _found:
		print("FAIL %d tests were found, only %d ran" % [_found, _passed + _failed])
	if not _skipped.is_empty():
		print("[engine] %d expectations are skipped in an emulator:" % _skipped.size())
		print("   ", "\n   ".join(_skipped))
	print("[engine] %d passed, %d failed" % [_passed, maxi(_failed, 0 if complete else 1)])
	get_tree().quit(0 if complete else 1)


func _run_file(file: String) -> void:
	var script: GDScript = load(FOLDER.path_join(file))
	if script == null or not script.can_instantiate():
		_found += 1
		_report(file, PackedStringArray(["does not compile"]) + _log.take_faults())
		return
	var methods := PackedStringArray()
	for method in script.get_script_method_list():
		var method_name: String = method["name"]
		var is_new := method_name.begins_with("test_") and not methods.has(method_name)
		if is_new and Filter.selects(argument, file, method_name):
			methods.append(method_name)
	_found += methods.size()
	for method_name in methods:
		var title := "%s %s" % [file.trim_suffix(".gd"), method_name]
		_watchdog.allow(title, BLOCK_LIMIT * Emulation.get_slowness())
		var test_case: TestCase = script.new()
		_report(title, await _run_test(test_case, method_name))


## Returns the failure messages.
func _run_test(test_case: TestCase, method_name: String) -> PackedStringArray:
	test_case.tree = get_tree()
	test_case.error_log = _log
	_test_finished = false
	_call_test(test_case, method_name)
	var limit := TEST_LIMIT * Emulation.get_slowness()
	var deadline := Time.get_ticks_msec() + limit * 1000.0
	while not _test_finished and Time.get_ticks_msec() < deadline:
		await get_tree().process_frame
	var failures := test_case.take_failures()
	if not _test_finished:
		failures.append("takes longer than %d s" % limit)
	for expectation in test_case.skipped:
		_skipped.append("%s: %s" % [method_name, expectation])
	test_case.free_nodes()
	failures.append_array(_log.take_faults())
	return failures


func _call_test(test_case: TestCase, method_name: String) -> void:
	@warning_ignore("redundant_await")
	await test_case.call(method_name)
	_test_finished = true


func _report(title: String, failures: PackedStringArray) -> void:
	if failures.is_empty():
		_passed += 1
		return
	_failed += 1
	print("FAIL %s" % title)
	for failure in failures:
		print("   %s" % failure)
