## The cost per frame of 1,000 drawn objects, compared with the engine's primitives of about the
## same size on the screen.
##
## godot --path godot_project --disable-vsync --script res://tests/bench/drawing.gd --
##     [--sizes=64x36,1152x648] [--frames=N] [--json=FILE]
##
## Each subject is drawn without changes, and with 200 objects changed in each frame. "frame" is the
## time of a whole frame, "render" of culling and draw calls; both are medians in milliseconds. A
## small size excludes the cost of pixels.
extends SceneTree

const BenchRows := preload("res://tests/bench/bench_rows.gd")
const DrawnWorld := preload("res://tests/bench/drawn_world.gd")

const SETTLING_FRAMES := 8
const DOCUMENT := &"ga_godot"

var _sizes: Array[Vector2i] = []
var _frames := 60
var _view: SubViewport


func _initialize() -> void:
	var path := ""
	var sizes := "64x36"
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with("--json="):
			path = argument.trim_prefix("--json=")
		elif argument.begins_with("--frames="):
			_frames = argument.trim_prefix("--frames=").to_int()
		elif argument.begins_with("--sizes="):
			sizes = argument.trim_prefix("--sizes=")
	for size in sizes.split(","):
		_sizes.append(Vector2i(size.get_slice("x", 0).to_int(), size.get_slice("x", 1).to_int()))
	_measure_all.call_deferred(path)


func _measure_all(path: String) -> void:
	_view = SubViewport.new()
	_view.own_world_3d = true
	_view.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	root.add_child(_view)
	RenderingServer.viewport_set_measure_render_time(_view.get_viewport_rid(), true)
	var rows: Array[Dictionary] = []
	for subject in DrawnWorld.SUBJECTS:
		rows.append_array(
			await _measure(DrawnWorld.make(subject), subject, {"still": false, "200 changed": true})
		)
	rows.append_array(
		await _measure(DrawnWorld.make_document(), DOCUMENT, {"document, 200 dragged": true})
	)
	DrawnWorld.free_shared()
	_view.free()
	quit(BenchRows.write(rows, path))


func _measure(
	world: DrawnWorld, subject: StringName, cases: Dictionary[String, bool]
) -> Array[Dictionary]:
	var rows: Array[Dictionary] = []
	_view.add_child(world)
	for size in _sizes:
		_view.size = size
		for case in cases:
			rows.append(await _measure_case(world, subject, case, cases[case]))
	world.free()
	return rows


func _measure_case(
	world: DrawnWorld, subject: StringName, case: String, changes: bool
) -> Dictionary:
	var times := PackedFloat64Array()
	var renders := PackedFloat64Array()
	var started := 0
	for frame in SETTLING_FRAMES + _frames:
		var now := Time.get_ticks_usec()
		if frame > SETTLING_FRAMES:
			times.append((now - started) / 1000.0)
			renders.append(
				(
					RenderingServer.viewport_get_measured_render_time_cpu(_view.get_viewport_rid())
					+ RenderingServer.get_frame_setup_time_cpu()
				)
			)
		started = now
		if changes:
			world.change(frame)
		await process_frame
	var draws := RenderingServer.viewport_get_render_info(
		_view.get_viewport_rid(),
		RenderingServer.VIEWPORT_RENDER_INFO_TYPE_VISIBLE,
		RenderingServer.VIEWPORT_RENDER_INFO_DRAW_CALLS_IN_FRAME
	)
	return {
		"case": case,
		"subject": subject,
		"size": "%dx%d" % [_view.size.x, _view.size.y],
		"frame": _median(times),
		"render": _median(renders),
		"draws": draws,
	}


func _median(values: PackedFloat64Array) -> float:
	values.sort()
	return values[values.size() / 2]
