@tool
extends EditorPlugin
## Drives the dock as a person would, one chapter of `chapters/` after another; each mistake prints
## a line that begins with [probe] FAIL. The user argument --chapters=NAME,NAME says which; see
## chapter.gd for those of pictures.

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
		_read_chapters()


func _read_chapters() -> void:
	var said := 0
	# Nothing is drawn, which takes most of the time, until a picture is taken.
	RenderingServer.render_loop_enabled = false
	for title in _titles():
		var script: GDScript = load("res://addons/dock_probe/chapters/%s.gd" % title)
		var chapter: Chapter = script.new(self)
		var start := Time.get_ticks_msec()
		@warning_ignore("redundant_await")
		await chapter.read()
		said += chapter.said
		print(
			(
				"[probe] %s: %d expectations, %.1f s"
				% [title, chapter.said, (Time.get_ticks_msec() - start) / 1000.0]
			)
		)
	RenderingServer.render_loop_enabled = true
	print("[probe] %d expectations" % said)
	print("[probe] done")
	get_tree().quit()


func _titles() -> PackedStringArray:
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with(OPTION):
			return argument.trim_prefix(OPTION).split(",")
	return []
