@tool
extends RefCounted
## Draws a document into a picture of any size, in its own world, and saves it as PNG.

const SceneDrawing := preload("../view/scene_drawing.gd")
const ViewPoint := preload("view_point.gd")
const SafeFile := preload("../document/safe_file.gd")

const MAX_SIZE := 8192
## The height in pixels of a picture in which lines and labels have their normal size.
const REFERENCE_HEIGHT := 720.0

## Size of the picture in pixels.
var size := Vector2i(1280, 720)
var view := ViewPoint.new()
## An alpha of 0 makes the background transparent.
var background := Color.TRANSPARENT
## Factor of line widths. Labels scale with the height automatically.
var line_scale := 1.0


## Returns why a picture cannot have this size, or an empty string.
static func size_error(requested: Vector2i) -> String:
	if requested.x < 1 or requested.y < 1:
		return (
			"The picture must be at least 1 x 1 pixels, not %d x %d." % [requested.x, requested.y]
		)
	if requested.x > MAX_SIZE or requested.y > MAX_SIZE:
		return (
			"The picture must be at most %d x %d pixels, not %d x %d."
			% [MAX_SIZE, MAX_SIZE, requested.x, requested.y]
		)
	return ""


## Draws the document as seen from `view`, together with extra nodes, which are freed. `host` is any
## node in the tree. Returns null if nothing can be drawn, for example without a display. A
## coroutine: use await.
func draw(host: Node, scene: GAScene, extra_nodes: Array[Node3D] = []) -> Image:
	if DisplayServer.get_name() == "headless" or not size_error(size).is_empty():
		for node in extra_nodes:
			node.free()
		return null
	var viewport := _make_viewport()
	var drawing := SceneDrawing.new()
	drawing.scene = scene
	viewport.add_child(drawing)
	for node in drawing.find_children("*", "GANode3D", true, false):
		(node as GANode3D).line_width *= line_scale
	for node in extra_nodes:
		viewport.add_child(node)
	host.add_child(viewport)
	for node in drawing.find_children("*", "GANode3D", true, false):
		(node as GANode3D).update_drawing()
	# An idle editor draws no frames unless forced.
	for i in 2:
		await host.get_tree().process_frame
		RenderingServer.force_draw(false)
	var image := viewport.get_texture().get_image()
	viewport.queue_free()
	if background.a == 0.0:
		_divide_by_alpha(image)
	return image


## Saves the picture. Returns an error message, or an empty string.
static func save(image: Image, path: String) -> String:
	if image == null:
		return "No picture was drawn: drawing requires a display."
	if path.is_empty():
		return "Enter a file name that ends with .png."
	if path.get_extension().to_lower() != "png":
		return "%s is not a PNG file name. Enter a file name that ends with .png." % path
	var outcome := SafeFile.write(path, image.save_png_to_buffer())
	if outcome == ERR_FILE_CANT_WRITE:
		return "%s cannot be written completely. Check the free space on the disk." % path
	return (
		""
		if outcome == OK
		else (
			"%s cannot be written: %s. Check that the folder exists and is writable."
			% [path, error_string(outcome).to_lower()]
		)
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


# Blending onto transparency premultiplies colors by alpha; PNG stores straight alpha.
static func _divide_by_alpha(image: Image) -> void:
	image.convert(Image.FORMAT_RGBA8)
	var data := image.get_data()
	for i in range(0, data.size(), 4):
		var alpha := data[i + 3]
		if alpha > 0 and alpha < 255:
			for channel in 3:
				data[i + channel] = mini(255, data[i + channel] * 255 / alpha)
	image.set_data(image.get_width(), image.get_height(), false, Image.FORMAT_RGBA8, data)
