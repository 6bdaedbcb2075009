extends Node
## Writes a picture of each document of the gallery, and a sheet with all of them, for the documentation. Ends the
## program; the last line is `[gallery] N written, N failed`.
##
## --gallery-pictures=DIR   the folder of the pictures
## --only=NAME,NAME         only these documents, and no sheet

const Gallery := preload("res://addons/ga_godot/playground/gallery.gd")
const PictureExport := preload("res://addons/ga_godot/playground/picture_export.gd")
const ViewPoint := preload("res://addons/ga_godot/playground/view_point.gd")

const SHEET_COLUMNS := 4
const SHEET_GAP := 6
const SHEET_CELL := Vector2i(316, 178)
const SHEET_COLOR := Color(0.16, 0.175, 0.2)

## The folder of the pictures.
var argument := ""


func _ready() -> void:
	_write_all.call_deferred()


func _write_all() -> void:
	var wanted := Gallery.list()
	var makes_sheet := true
	for other in OS.get_cmdline_user_args():
		if other.begins_with("--only="):
			wanted = other.trim_prefix("--only=").split(",")
			makes_sheet = false
	var pictures: Array[Image] = []
	for example in wanted:
		var picture := await _draw(example)
		if _save(picture, example):
			pictures.append(picture)
	var failed := wanted.size() - pictures.size()
	if makes_sheet and failed == 0 and not _save(_make_sheet(pictures), "all"):
		failed += 1
	print("[gallery] %d written, %d failed" % [pictures.size(), failed])
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


func _save(picture: Image, title: String) -> bool:
	var error := PictureExport.save(picture, argument.path_join(title + ".png"))
	if not error.is_empty():
		printerr("FAIL %s" % error)
	return error.is_empty()


func _make_sheet(pictures: Array[Image]) -> Image:
	var rows := ceili(float(pictures.size()) / SHEET_COLUMNS)
	var step := SHEET_CELL + Vector2i(SHEET_GAP, SHEET_GAP)
	var sheet := Image.create_empty(SHEET_COLUMNS * step.x + SHEET_GAP, rows * step.y + SHEET_GAP, false, Image.FORMAT_RGB8)
	sheet.fill(SHEET_COLOR)
	for i in pictures.size():
		var small: Image = pictures[i].duplicate()
		small.convert(Image.FORMAT_RGB8)
		small.resize(SHEET_CELL.x, SHEET_CELL.y, Image.INTERPOLATE_LANCZOS)
		sheet.blit_rect(small, Rect2i(Vector2i.ZERO, SHEET_CELL), Vector2i(SHEET_GAP, SHEET_GAP) + step * Vector2i(i % SHEET_COLUMNS, i / SHEET_COLUMNS))
	return sheet
