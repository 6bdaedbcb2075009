## Inputs and calls that once took long, were accepted silently, or did not end. Runs one case and
## prints its value; tools/bench robustness runs all of them.
##
## godot --headless --path godot_project --script res://tests/bench/robustness.gd -- CASE
extends SceneTree

const PREFIX := "[value] "
const MEBIBYTE := 1 << 20
## Of the 16 MiB that a document may have, without what precedes and follows the entries.
const ROOM := 16 * MEBIBYTE - 100
const DAY := 86400.0
const SETTINGS := [
	"position_tolerance", "rotation_tolerance", "max_latency", "send_rate", "ticks_per_second"
]
## Values that are invalid for each of these settings, and those for one of them.
const INVALID: Array[float] = [-1.0, 0.0, 1e-300, 1e-9, 2e7, 1e300, -1e300, INF, -INF, NAN]
const INVALID_ONE: Dictionary[String, float] = {"max_latency": 100.0, "ticks_per_second": 20000.0}
## Called by the inspector.
const INSPECTOR_METHOD := "_get_linked_undo_properties"

var _cases: Dictionary[String, Callable] = {
	"refused_entries_20000": _load_copies.bind('{"name":"e1","expression":1}', 20000),
	"refused_entries_16_mib": _load_copies.bind('{"name":"e1","expression":1}', ROOM / 29),
	"valid_entries_70000": _load_entries.bind(70000, func(_i: int) -> String: return "1"),
	"valid_entries_65536": _load_entries.bind(65536, func(_i: int) -> String: return "1"),
	"cycle_65536":
	_load_entries.bind(65536, func(i: int) -> String: return "a%d" % ((i + 1) % 65536)),
	"cycle_16_mib": _load_entries.bind(320000, func(i: int) -> String: return "a%d" % (i + 1)),
	"attributes_1000000": _load_attributes.bind(1000000),
	"flush_after_a_day": _flush_after.bind(DAY),
	"flush_after_1e9_s": _flush_after.bind(1e9),
	"invalid_settings": _count_invalid_settings,
	"codec_tolerance_1e300": _encode_with_tolerance.bind(1e300),
	"internal_methods": _count_internal_methods,
}


func _initialize() -> void:
	Engine.print_error_messages = false
	var value: float = _cases[OS.get_cmdline_user_args()[0]].call()
	print(PREFIX, value)
	quit()


func _load_copies(entry: String, count: int) -> float:
	return _load("[%s]" % ",".join(_texts(count, func(_i: int) -> String: return entry)))


func _load_entries(count: int, expression: Callable) -> float:
	var entry := func(i: int) -> String:
		return '{"name": "a%d", "expression": "%s"}' % [i, expression.call(i)]
	return _load("[%s]" % ",\n".join(_texts(count, entry)))


func _load_attributes(count: int) -> float:
	var attribute := func(i: int) -> String: return '"a%d": 1' % i
	return _load('[], "attributes": {%s}' % ", ".join(_texts(count, attribute)))


func _texts(count: int, text: Callable) -> PackedStringArray:
	var texts := PackedStringArray()
	for i in count:
		texts.append(text.call(i) as String)
	return texts


## Milliseconds until a document is open or refused.
func _load(entries: String) -> float:
	var json := '{"entries": %s}' % entries
	var scene := GAScene.new()
	return _milliseconds(func() -> void: scene.load_json(json))


## Milliseconds of MotorSender.flush for 100 bodies after a jump of the clock.
func _flush_after(seconds: float) -> float:
	var sender := MotorSender.new()
	sender.add_receiver(1, 0.0)
	for body in 100:
		sender.add_body(body, Transform3D.IDENTITY)
	sender.flush(0.0)
	for body in 100:
		sender.observe(body, seconds, Transform3D(Basis.IDENTITY, Vector3(body, 0.0, 0.0)))
	return _milliseconds(func() -> void: sender.flush(seconds))


## The processor time that work takes, where the system tells it finely enough, else the time on the
## clock.
func _milliseconds(work: Callable) -> float:
	var begin := Time.get_ticks_usec()
	var processor_begin := _processor_nanoseconds()
	work.call()
	var processor_time := (_processor_nanoseconds() - processor_begin) * 1e-6
	var time := (Time.get_ticks_usec() - begin) * 1e-3
	return minf(processor_time, time) if processor_time > 0.0 else time


func _processor_nanoseconds() -> int:
	var file := FileAccess.open("/proc/self/schedstat", FileAccess.READ)
	return file.get_line().get_slice(" ", 0).to_int() if file != null else 0


## The number of invalid values that settings take.
func _count_invalid_settings() -> float:
	var taken := 0
	for type: StringName in [&"MotorSender", &"MotorCodec", &"MotorSynchronizer"]:
		for property: String in SETTINGS:
			for value: float in INVALID + [INVALID_ONE.get(property, -1.0)]:
				var object: Object = ClassDB.instantiate(type)
				if property in object:
					object.set(property, value)
					var now: float = object.get(property)
					taken += 1 if now == value or not is_finite(now) else 0
				if object is Node:
					object.free()
	return taken


## The number of bytes that one pose takes.
func _encode_with_tolerance(tolerance: float) -> float:
	var codec := MotorCodec.new()
	codec.position_tolerance = tolerance
	return codec.encode(PackedInt32Array([1]), [Transform3D.IDENTITY]).size()


## The number of methods that scripts can call but are not documented.
func _count_internal_methods() -> float:
	var count := 0
	for type in ClassDB.get_class_list():
		if ClassDB.class_get_api_type(type) == ClassDB.API_EXTENSION:
			for method in ClassDB.class_get_method_list(type, true):
				var title: String = method["name"]
				count += 1 if title.begins_with("_") and title != INSPECTOR_METHOD else 0
	return count
