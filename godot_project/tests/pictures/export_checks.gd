extends RefCounted
## Checks of exported pictures: size, background, alpha, file, and error messages.

const Gallery := preload("res://addons/ga_godot/playground/document/gallery.gd")
const PictureComparison := preload("res://tests/pictures/picture_comparison.gd")
const PictureDialog := preload("res://addons/ga_godot/playground/picture/picture_dialog.gd")
const PictureExport := preload("res://addons/ga_godot/playground/picture/picture_export.gd")
const ViewPoint := preload("res://addons/ga_godot/playground/picture/view_point.gd")

const TITLE := "gallery_three_spheres"
const EXAMPLE := "three_spheres"
const SIZE := Vector2i(640, 360)
const FILE := "user://export_checks.png"
## Invalid paths with the beginnings of the error messages.
const WRONG_PATHS: Dictionary[String, String] = {
	"user://there/is/no/folder.png": "user://there/is/no/folder.png cannot be written",
	"user://picture.jpg": "user://picture.jpg is not a PNG file name",
	" ": "Enter a file name",
}

var _host: Node
var _problems := PackedStringArray()


func _init(host: Node) -> void:
	_host = host


## Draws the reference. A coroutine.
func draw_reference() -> Image:
	return await _draw(SIZE, true)


## Returns descriptions of the failed checks. A coroutine.
func find_problems(reference: Image) -> PackedStringArray:
	var opaque := await _draw(SIZE, true)
	_expect(opaque.get_size() == SIZE, "the size is %s" % opaque.get_size())
	_expect_alike("the export", opaque, reference)
	var changed := Gallery.load_example(EXAMPLE)
	changed.set_entry_attribute("pair", "visible", false)
	_expect(
		not PictureComparison.compare(await _draw(SIZE, true, changed), reference).is_alike(),
		"the comparison does not detect a removed point pair"
	)
	_check_transparent(await _draw(SIZE, false), opaque)
	await _check_larger(reference)
	await _check_dialog()
	return _problems


func _check_transparent(picture: Image, opaque: Image) -> void:
	_expect(
		picture.get_size() == SIZE, "the size of the transparent picture is %s" % picture.get_size()
	)
	for corner: Vector2i in [Vector2i.ZERO, SIZE - Vector2i.ONE]:
		_expect(picture.get_pixelv(corner).a == 0.0, "the corner %s is not transparent" % corner)
	_expect(
		picture.get_used_rect().size.x > SIZE.x / 3,
		"nothing visible in %s" % picture.get_used_rect()
	)
	# Over the background it must equal the opaque picture.
	var laid := Image.create_empty(SIZE.x, SIZE.y, false, Image.FORMAT_RGBA8)
	laid.fill(ViewPoint.DEFAULT_BACKGROUND)
	laid.blend_rect(picture, Rect2i(Vector2i.ZERO, SIZE), Vector2i.ZERO)
	_expect_alike("the transparent picture on its background", laid, opaque)


func _check_larger(reference: Image) -> void:
	var picture := await _draw(2 * SIZE, true)
	_expect(
		picture.get_size() == 2 * SIZE, "the size of the larger picture is %s" % picture.get_size()
	)
	picture.resize(SIZE.x, SIZE.y, Image.INTERPOLATE_LANCZOS)
	# Lines are smoother, so allow more.
	var comparison := PictureComparison.compare(picture, reference)
	_expect(
		comparison.obstacle.is_empty() and comparison.share < 0.02 and comparison.mean < 1.0,
		"the larger picture, scaled down: %s" % comparison.describe()
	)


func _check_dialog() -> void:
	var scene := Gallery.load_example(EXAMPLE)
	var files := FileDialog.new()
	files.access = FileDialog.ACCESS_USERDATA
	var dialog := PictureDialog.new(files)
	_host.add_child(dialog)
	var paths: Array[String] = []
	dialog.saved.connect(func(path: String) -> void: paths.append(path))
	dialog.ask(scene, ViewPoint.of(scene), SIZE / 2)
	var path: LineEdit = dialog.find_child("Path", true, false)
	var sizes: OptionButton = dialog.find_child("Size", true, false)
	sizes.select(PictureDialog.Size.TWICE)
	for wrong: String in WRONG_PATHS:
		path.text = wrong
		var message := await dialog.export_picture()
		_expect(
			message.begins_with(WRONG_PATHS[wrong]) and dialog.visible,
			'the error for "%s" is "%s"' % [wrong, message]
		)
	path.text = FILE
	var error := await dialog.export_picture()
	_expect(
		error.is_empty() and not dialog.visible and paths.size() == 1 and paths[0] == FILE,
		"the dialog did not save: %s, %s" % [error, paths]
	)
	var written := Image.load_from_file(FILE)
	_expect(
		written != null and written.get_size() == SIZE, "the file does not have the chosen size"
	)
	DirAccess.remove_absolute(FILE)
	dialog.queue_free()


func _draw(size: Vector2i, with_background: bool, scene := Gallery.load_example(EXAMPLE)) -> Image:
	var export := PictureExport.new()
	export.size = size
	export.view = ViewPoint.of(scene)
	export.line_scale = float(size.y) / SIZE.y
	export.background = export.view.background if with_background else Color.TRANSPARENT
	return await export.draw(_host, scene)


func _expect_alike(what: String, picture: Image, expected: Image) -> void:
	var comparison := PictureComparison.compare(picture, expected)
	_expect(comparison.is_alike(), "%s: %s" % [what, comparison.describe()])


func _expect(condition: bool, what: String) -> void:
	if not condition:
		_problems.append(what)
