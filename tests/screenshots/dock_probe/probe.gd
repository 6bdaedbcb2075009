@tool
extends EditorPlugin
## Operates the dock by input events, one chapter of `chapters/` after another. Each failure prints
## a line that starts with [probe] FAIL. The user argument --chapters=NAME,NAME selects the
## chapters; see chapters/looks.gd for those about pictures.

const Chapter := preload("chapter.gd")

const OPTION := "--chapters="
const FIRST_FRAMES := 40

var _frames := 0


func _process(_delta: float) -> void:
	if (
		DisplayServer.get_name() == "headless"
		or EditorInterface.get_resource_filesystem().is_scanning()
	):
		return
	_frames += 1
	if _frames >= FIRST_FRAMES:
		set_process(false)
		_run_chapters()


func _run_chapters() -> void:
	var expectations := 0
	# Drawing takes most of the time, so it is off except for pictures.
	RenderingServer.render_loop_enabled = false
	for title in _titles():
		var script: GDScript = load("res://addons/dock_probe/chapters/%s.gd" % title)
		var chapter: Chapter = script.new(self)
		var start := Time.get_ticks_msec()
		@warning_ignore("redundant_await")
		await chapter.run()
		expectations += chapter.expectations
		print(
			(
				"[probe] %s: %d expectations, %.1f s"
				% [title, chapter.expectations, (Time.get_ticks_msec() - start) / 1000.0]
			)
		)
	RenderingServer.render_loop_enabled = true
	print("[probe] %d expectations" % expectations)
	print("[probe] done")
	get_tree().quit()


func _titles() -> PackedStringArray:
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with(OPTION):
			return argument.trim_prefix(OPTION).split(",")
	return []
