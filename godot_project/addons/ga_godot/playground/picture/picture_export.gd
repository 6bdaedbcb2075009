@tool
extends RefCounted
## Draws a document into a picture of any size, in a world of its own, and saves it as PNG.

const SceneDrawing := preload("../view/scene_drawing.gd")
const ViewPoint := preload("view_point.gd")

const LARGEST := 8192
## Pixels of a picture in whose height lines and letters have their usual size.
const USUAL_HEIGHT := 720.0

## In pixels.
var size := Vector2i(1280, 720)
var view := ViewPoint.new()
## With alpha 0, what is empty is transparent.
var background := Color.TRANSPARENT
## Times the usual width of lines; labels keep their share of the height by themselves.
var line_scale := 1.0


## Why there can be no picture of that size; empty if there can.
static func size_error(wanted: Vector2i) -> String:
	if wanted.x < 1 or wanted.y < 1:
		return (
			"A picture needs at least one pixel in each direction, not %d x %d."
			% [wanted.x, wanted.y]
		)
	if wanted.x > LARGEST or wanted.y > LARGEST:
		return (
			"A picture has at most %d pixels in each direction, not %d x %d."
			% [LARGEST, wanted.x, wanted.y]
		)
	return ""


## The document as seen from `view`; what else stands in the world besides can be given, and is freed. To be awaited.
## Null where nothing can be drawn, as without a display. The host is any node in the tree.
func draw(host: Node, scene: GAScene, besides: Array[Node3D] = []) -> Image:
	if DisplayServer.get_name() == "headless" or not size_error(size).is_empty():
		for node in besides:
			node.free()
		return null
	var viewport := _make_viewport()
	var drawing := SceneDrawing.new()
	drawing.scene = scene
	viewport.add_child(drawing)
	for node in drawing.find_children("*", "GANode3D", true, false):
		(node as GANode3D).line_width *= line_scale
	for node in besides:
		viewport.add_child(node)
	host.add_child(viewport)
	for node in drawing.find_children("*", "GANode3D", true, false):
		(node as GANode3D).update_drawing()
	# An editor that has nothing to do draws no frames by itself.
	for i in 2:
		await host.get_tree().process_frame
		RenderingServer.force_draw(false)
	var image := viewport.get_texture().get_image()
	viewport.queue_free()
	if background.a == 0.0:
		_divide_by_alpha(image)
	return image


## Why the picture could not be saved; empty if it was.
static func save(image: Image, path: String) -> String:
	if image == null:
		return "There is no picture: drawing needs a display."
	if path.is_empty():
		return "Give the picture a file name that ends with .png."
	if path.get_extension().to_lower() != "png":
		return "%s: a picture is saved as PNG; give it a name that ends with .png." % path
	var file := FileAccess.open(path, FileAccess.WRITE)
	if file == null:
		return (
			"%s cannot be written: %s. Is there such a folder, and may you write there?"
			% [path, error_string(FileAccess.get_open_error()).to_lower()]
		)
	return (
		""
		if file.store_buffer(image.save_png_to_buffer())
		else "%s cannot be written to its end. Is the disk full?" % path
	)


func _make_viewport() -> SubViewport:
	var viewport := SubViewport.new()
	viewport.size = size
	viewport.own_world_3d = true
	viewport.msaa_3d = Viewport.MSAA_8X
	viewport.transparent_bg = background.a == 0.0
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	if background.a > 0.0:
		world.environment.background_mode = Environment.BG_COLOR
		world.environment.background_color = background
	viewport.add_child(world)
	var camera := Camera3D.new()
	viewport.add_child(camera)
	view.apply_to(camera)
	camera.current = true
	return viewport


# What is blended onto nothing has its colour multiplied by the alpha; a PNG keeps them apart.
static func _divide_by_alpha(image: Image) -> void:
	image.convert(Image.FORMAT_RGBA8)
	var data := image.get_data()
	for i in range(0, data.size(), 4):
		var alpha := data[i + 3]
		if alpha > 0 and alpha < 255:
			for channel in 3:
				data[i + channel] = mini(255, data[i + channel] * 255 / alpha)
	image.set_data(image.get_width(), image.get_height(), false, Image.FORMAT_RGBA8, data)
