extends Node
## Compares screenshots of the project's scenes with references, and checks that the comparison
## detects objects that moved or vanished. Quits; the last line is `[pictures] N passed, N failed`.
##
## --screenshots=DIR   folder of the references
## --output=DIR        folder for the screenshots of failed comparisons
## --update            write the references instead of comparing
## --picture=NAME      only this screenshot
##
## The screenshots have the size of the window.

const DrawnChanges := preload("res://tests/pictures/drawn_changes.gd")
const ExportChecks := preload("res://tests/pictures/export_checks.gd")
const Interpolation := preload("res://demos/interpolation/interpolation.gd")
const LineChecks := preload("res://tests/pictures/line_checks.gd")
const PictureComparison := preload("res://tests/pictures/picture_comparison.gd")
const Scenes := preload("res://tests/pictures/scenes.gd")

## Frames until shaders are compiled and layouts are settled.
const SETTLING_FRAMES := 6
## A displacement of the cube that must be detected, as a fraction of its path.
const NOTICED_STEP := 0.05

## Folder of the references.
var argument := ""

var _output := ""
var _only := ""
var _passed := 0
var _failed := 0
var _last_draw_calls := 0


func _ready() -> void:
	var update := false
	for other in OS.get_cmdline_user_args():
		if other.begins_with("--output="):
			_output = other.trim_prefix("--output=")
		elif other.begins_with("--picture="):
			_only = other.trim_prefix("--picture=")
		update = update or other == "--update"
	if DisplayServer.get_name() == "headless":
		printerr("Screenshots need a display. Run under Xvfb if there is none.")
		get_tree().quit(1)
		return
	if update:
		_update.call_deferred()
	else:
		_compare_all.call_deferred()


func _update() -> void:
	var scenes := _scenes()
	for title: String in scenes:
		var picture := await _take(scenes[title])
		if picture.save_png(_reference_path(title)) != OK:
			printerr("Cannot write %s." % _reference_path(title))
			get_tree().quit(1)
			return
		print("wrote %s" % _reference_path(title))
	if not _only.is_empty():
		get_tree().quit()
		return
	var exported := await ExportChecks.new(self).draw_reference()
	get_tree().quit(0 if exported.save_png(_reference_path(ExportChecks.TITLE)) == OK else 1)


func _compare_all() -> void:
	var scenes := _scenes()
	for title: String in scenes:
		await _expect_alike(title, scenes[title])
	if _only.is_empty():
		await _expect_different("a cube that moved by 5% of its path", _with_moved_cube)
		await _expect_different("a cube that vanished", _with_hidden.bind(^"Cube"))
		await _expect_different("paths that vanished", _with_hidden.bind(^"Paths"))
		await _expect_different("a floor that vanished", _with_hidden.bind(^"Floor"))
		await _expect_same_after_changes()
		await _expect_shared_draw_calls()
		await _check_export()
		await _check_line()
		await _expect_different(
			"the lab without one of its paths", _without_screw, "interpolation_lab_frames"
		)
	print("[pictures] %d passed, %d failed" % [_passed, _failed])
	get_tree().quit(0 if _failed == 0 else 1)


func _expect_alike(title: String, make_scene: Callable) -> void:
	var picture := await _take(make_scene)
	var reference := _load_reference(title)
	if reference == null:
		_fail("%s: there is no reference %s" % [title, _reference_path(title)])
		return
	var comparison := PictureComparison.compare(picture, reference)
	print("%s: %s" % [title, comparison.describe()])
	if comparison.is_alike():
		_passed += 1
		return
	_fail("%s: differs from the reference" % title)
	if not _output.is_empty():
		picture.save_png(_output.path_join(title + ".png"))
		print("   screenshot: %s" % _output.path_join(title + ".png"))


func _scenes() -> Dictionary[String, Callable]:
	var scenes := Scenes.list()
	if _only.is_empty():
		return scenes
	return {_only: scenes[_only]}


## Checks that the changed scene does not match the reference of the original, by default the demo
## without panels.
func _expect_different(
	change: String, make_scene: Callable, title := "interpolation_paths"
) -> void:
	var reference := _load_reference(title)
	if reference == null:
		_fail("%s: there is no reference" % change)
		return
	var comparison := PictureComparison.compare(await _take(make_scene), reference)
	print("%s: %s" % [change, comparison.describe()])
	if comparison.is_alike() or not comparison.obstacle.is_empty():
		_fail("%s is not detected" % change)
	else:
		_passed += 1


func _check_export() -> void:
	var reference := _load_reference(ExportChecks.TITLE)
	if reference == null:
		_fail("exported pictures: there is no reference %s" % _reference_path(ExportChecks.TITLE))
		return
	var problems := await ExportChecks.new(self).find_problems(reference)
	for problem in problems:
		_fail("exported pictures: %s" % problem)
	_passed += int(problems.is_empty())


func _check_line() -> void:
	var problem := await LineChecks.find_problem(self)
	if problem.is_empty():
		_passed += 1
	else:
		_fail(problem)


## Drawn objects do not depend on earlier states.
func _expect_same_after_changes() -> void:
	var picture := await _take(_with_changes.bind(true))
	var comparison := PictureComparison.compare(picture, await _take(_with_changes.bind(false)))
	print("objects after changes: %s" % comparison.describe())
	if comparison.is_alike():
		_passed += 1
		return
	_fail("objects after changes differ from those created in the final state")
	if not _output.is_empty():
		picture.save_png(_output.path_join("drawn_changes.png"))


## A hundred circles take as many draw calls as one.
func _expect_shared_draw_calls() -> void:
	await _take(_with_circles.bind(1))
	var one := _last_draw_calls
	await _take(_with_circles.bind(100))
	print("draw calls of 1 and 100 circles: %d, %d" % [one, _last_draw_calls])
	if one > 0 and _last_draw_calls == one:
		_passed += 1
	else:
		_fail("a hundred circles are not drawn in one batch")


func _with_circles(parent: Node, count: int) -> Node:
	var scene := Node3D.new()
	var camera := Camera3D.new()
	camera.position = Vector3(0, 0, 10)
	scene.add_child(camera)
	for i in count:
		var node := GANode3D.new()
		node.multivector = Multivector.circle(
			Vector3(0.1 * (i % 10), 0.1 * (i / 10), 0.0), Vector3.BACK, 1.0
		)
		scene.add_child(node)
	parent.add_child(scene)
	return scene


func _with_changes(parent: Node, through_changes: bool) -> Node:
	var picture := DrawnChanges.make(through_changes)
	parent.add_child(picture)
	return picture


func _with_moved_cube(parent: Node) -> Node:
	var demo := Scenes.interpolation(parent, 0, MultivectorLerp.SCREW, false)
	demo.set_factor(Scenes.FACTOR + NOTICED_STEP)
	return demo


func _with_hidden(parent: Node, path: NodePath) -> Node:
	var demo := Scenes.interpolation(parent, 0, MultivectorLerp.SCREW, false)
	var node: Node3D = demo.get_node(path)
	node.hide()
	return demo


func _without_screw(parent: Node) -> Node:
	var picture := Scenes.interpolation_lab(parent, "frame")
	var path: Node3D = picture.get_node(^"Interpolation/Screw/Path")
	path.hide()
	return picture


func _take(make_scene: Callable) -> Image:
	var scene: Node = make_scene.call(self)
	for i in SETTLING_FRAMES:
		await RenderingServer.frame_post_draw
	var picture := get_viewport().get_texture().get_image()
	_last_draw_calls = get_viewport().get_render_info(
		Viewport.RENDER_INFO_TYPE_VISIBLE, Viewport.RENDER_INFO_DRAW_CALLS_IN_FRAME
	)
	scene.queue_free()
	await get_tree().process_frame
	return picture


func _reference_path(title: String) -> String:
	return argument.path_join(title + ".png")


func _load_reference(title: String) -> Image:
	if not FileAccess.file_exists(_reference_path(title)):
		return null
	return Image.load_from_file(_reference_path(title))


func _fail(reason: String) -> void:
	_failed += 1
	print("FAIL %s" % reason)
