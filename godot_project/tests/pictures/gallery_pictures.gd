extends Node
## Renders pictures for the documentation: each document of the gallery, a contact sheet of all, and
## screenshots of the playground. Quits; the last line is `[gallery] N written, N failed`.
##
## --gallery-pictures=DIR   output folder
## --only=NAME,NAME         render only these documents

const Gallery := preload("res://addons/ga_godot/playground/document/gallery.gd")
const Playground := preload("res://demos/playground/playground.gd")
const PictureExport := preload("res://addons/ga_godot/playground/picture/picture_export.gd")
const ViewPoint := preload("res://addons/ga_godot/playground/picture/view_point.gd")

const PLAYGROUND := "res://demos/playground/playground.tscn"
const PLAYGROUND_SIZE := Vector2i(1280, 720)
## Screenshots of the playground: example, selected entry, and whether the theme is light.
const PLAYGROUNDS: Dictionary[String, Array] = {
	"playground": ["three_spheres", "A", false],
	"playground_light": ["sphere_and_plane", "touched", true],
}
const SETTLING_FRAMES := 8
const SHEET_COLUMNS := 3
const SHEET_GAP := 6
const SHEET_CELL := Vector2i(320, 180)
const SHEET_COLOR := Color(0.16, 0.175, 0.2)

## The output folder.
var argument := ""


func _ready() -> void:
	_write_all.call_deferred()


func _write_all() -> void:
	var wanted := Gallery.list()
	var writes_all := true
	for other in OS.get_cmdline_user_args():
		if other.begins_with("--only="):
			wanted = other.trim_prefix("--only=").split(",")
			writes_all = false
	var pictures: Array[Image] = []
	for example in wanted:
		var picture := await _draw(example)
		if _save(picture, example):
			pictures.append(picture)
	var failed := wanted.size() - pictures.size()
	var written := pictures.size()
	if writes_all and failed == 0:
		var others: Dictionary[String, Image] = {"all": _make_sheet(pictures)}
		for title in PLAYGROUNDS:
			others[title] = await _open(
				PLAYGROUNDS[title][0] as String,
				PLAYGROUNDS[title][1] as String,
				PLAYGROUNDS[title][2] as bool
			)
		for title in others:
			var is_saved := _save(others[title], title)
			written += int(is_saved)
			failed += int(not is_saved)
	print("[gallery] %d written, %d failed" % [written, failed])
	get_tree().quit(0 if failed == 0 else 1)


func _draw(example: String) -> Image:
	var scene := Gallery.load_example(example)
	if scene == null:
		printerr("FAIL %s" % Gallery.error_of(example))
		return null
	var export := PictureExport.new()
	export.view = ViewPoint.of(scene)
	export.background = export.view.background
	return await export.draw(self, scene)


## Takes a screenshot of the playground.
func _open(example: String, selected: String, light: bool) -> Image:
	var viewport := SubViewport.new()
	viewport.size = PLAYGROUND_SIZE
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(viewport)
	var packed: PackedScene = load(PLAYGROUND)
	var playground: Playground = packed.instantiate()
	playground.state_path = ""
	viewport.add_child(playground)
	playground.set_light(light)
	# The layout is done in the next frame.
	await RenderingServer.frame_post_draw
	playground.panel.document.show_scene(Gallery.load_example(example), "")
	playground.panel.list.select([selected])
	for i in SETTLING_FRAMES:
		await RenderingServer.frame_post_draw
	var picture := viewport.get_texture().get_image()
	viewport.queue_free()
	return picture


func _save(picture: Image, title: String) -> bool:
	var error := PictureExport.save(picture, argument.path_join(title + ".png"))
	if not error.is_empty():
		printerr("FAIL %s" % error)
	return error.is_empty()


func _make_sheet(pictures: Array[Image]) -> Image:
	var rows := ceili(float(pictures.size()) / SHEET_COLUMNS)
	var step := SHEET_CELL + Vector2i(SHEET_GAP, SHEET_GAP)
	var sheet := Image.create_empty(
		SHEET_COLUMNS * step.x + SHEET_GAP, rows * step.y + SHEET_GAP, false, Image.FORMAT_RGB8
	)
	sheet.fill(SHEET_COLOR)
	for i in pictures.size():
		var small: Image = pictures[i].duplicate()
		small.convert(Image.FORMAT_RGB8)
		small.resize(SHEET_CELL.x, SHEET_CELL.y, Image.INTERPOLATE_LANCZOS)
		sheet.blit_rect(
			small,
			Rect2i(Vector2i.ZERO, SHEET_CELL),
			Vector2i(SHEET_GAP, SHEET_GAP) + step * Vector2i(i % SHEET_COLUMNS, i / SHEET_COLUMNS)
		)
	return sheet
