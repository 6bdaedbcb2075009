## Default arguments, static methods, enums, and calls with invalid arguments, which must print an
## error and not crash.
extends Checks

var values: SampleValues = SampleValues.new()


## Evaluates a call without the parser's checks and without printing an error. Returns whether the
## call failed.
func call_fails(text: String) -> bool:
	var expression := Expression.new()
	same(expression.parse(text, ["values"]), OK)
	expression.execute([values], null, false)
	return expression.has_execute_failed()


func check_defaults() -> void:
	same(values.repeat("x"), "x-x")
	same(values.repeat("x", 3), "x-x-x")
	same(values.repeat("x", 3, ""), "xxx")
	same(values.call("repeat", "x"), "x-x")
	same(values.callv("repeat", ["x", 1]), "x")
	same(SampleValues.join("a"), "ab3")
	same(SampleValues.join("a", "c"), "ac3")
	same(SampleValues.join("a", "c", 4), "ac4")
	same(SampleNote.make("a").weight, 2.5)
	var method: Dictionary = method_of("repeat")
	same(method["default_args"], [2, "-"])


func check_enums_and_constants() -> void:
	same(values.mix(SampleValues.GREEN, SampleValues.GREEN), SampleValues.GREEN)
	same(values.mix(SampleValues.GREEN, SampleValues.RED), SampleValues.BLUE)
	same(SampleValues.BLUE as int, 40)
	same(
		ClassDB.class_get_enum_constants("SampleValues", "Hue", true),
		PackedStringArray(["RED", "GREEN", "BLUE"])
	)
	same(ClassDB.class_get_integer_constant_enum("SampleValues", "GREEN"), &"Hue")
	same(ClassDB.class_get_enum_list("SampleValues", true), PackedStringArray(["Hue"]))
	same(method_of("mix")["args"][0]["class_name"], &"SampleValues.Hue")


func check_statics() -> void:
	same(ClassDB.class_call_static("SampleValues", "join", "p", "q", 1), "pq1")
	same(method_of("join")["flags"] & METHOD_FLAG_STATIC, METHOD_FLAG_STATIC)
	same(method_of("negate")["flags"] & METHOD_FLAG_CONST, METHOD_FLAG_CONST)


func check_wrong_numbers_of_arguments() -> void:
	same(call_fails("values.negate()"), true)
	same(call_fails("values.negate(true, false)"), true)
	same(call_fails("values.repeat()"), true)
	same(call_fails('values.repeat("a", 1, "b", 2)'), true)
	same(call_fails("values.count_alive(1)"), true)
	same(call_fails("values.negate(true)"), false)
	same(call_fails('values.repeat("a")'), false)


func check_wrong_types_of_arguments() -> void:
	same(call_fails('values.negate("yes")'), true)
	same(call_fails("values.combine(1, 2)"), true)
	same(call_fails("values.combine(Vector3(), Vector2())"), true)
	same(call_fails('values.floats("text")'), true)
	same(call_fails("values.summarize({})"), true)
	# bindings/ rejects an object of another class; godot-cpp converts it to null.
	for method: String in ["describe_note", "describe_node"]:
		var expression := Expression.new()
		same(expression.parse("values.%s(values)" % method, ["values"]), OK)
		var result: Variant = expression.execute([values], null, false)
		same(expression.has_execute_failed() or result == "null", true)
	same(call_fails("values.describe_object(5)"), true)
	same(call_fails("values.describe_object(null)"), false)
	same(call_fails("values.describe_object(values)"), false)


func check_what_callers_are_told() -> void:
	expect_error(
		(
			"Invalid type in function 'combine (via call)' in base 'SampleValues'."
			+ " Cannot convert argument 3 from String to Vector3."
		)
	)
	call_wrongly(&"combine", [Vector3.UP, "up"])
	expect_error(
		"Invalid call to function 'add_up (via call)' in base 'SampleValues'. Expected 4 argument(s)."
	)
	call_wrongly(&"add_up", [1, 2])
	expect_error(
		"Invalid call to function 'negate (via call)' in base 'SampleValues'. Expected 1 argument(s)."
	)
	call_wrongly(&"negate", [1, 2, 3])
	same(values.negate(false), true)


## Causes a script error, which ends this function but not its caller.
func call_wrongly(method: StringName, arguments: Array) -> void:
	if arguments.size() == 3:
		values.call(method, arguments[0], arguments[1], arguments[2])
	else:
		values.call(method, arguments[0], arguments[1])


func check_errors_keep_their_text() -> void:
	expect_error("Ärger: 100% wörtlich")
	SampleValues.fail_with("Ärger: 100% wörtlich")
	same(true, true)


func check_messages() -> void:
	var listener := Listener.new()
	expect_error("wrong: ö")
	OS.add_logger(listener)
	SampleValues.say("ö")
	OS.remove_logger(listener)
	same(listener.heard, ["error: wrong: ö", "warning: odd: ö"])


class Listener:
	extends Logger

	var heard: Array[String] = []

	func _log_error(
		_function: String,
		_file: String,
		_line: int,
		code: String,
		rationale: String,
		_editor_notify: bool,
		error_type: int,
		_script_backtraces: Array[ScriptBacktrace]
	) -> void:
		heard.append(
			(
				"%s: %s"
				% [
					"warning" if error_type == ERROR_TYPE_WARNING else "error",
					code if rationale.is_empty() else rationale
				]
			)
		)
