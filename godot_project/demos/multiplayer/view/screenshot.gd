extends RefCounted
## Saves pictures of a viewport whose 3D rendering was off.

const SafeFile := preload("res://addons/ga_godot/playground/document/safe_file.gd")

## Frames until shaders are compiled and shadows are drawn.
const SETTLING_FRAMES := 4


## Draws a few frames, then saves one as PNG at [param path]. Prints an error if that fails.
static func save(viewport: Viewport, path: String) -> void:
	viewport.disable_3d = false
	for frame: int in SETTLING_FRAMES:
		await RenderingServer.frame_post_draw
	store(viewport.get_texture().get_image(), path)


## Writes an image as PNG, completely or not at all. Prints an error if that fails.
static func store(image: Image, path: String) -> Error:
	var error := SafeFile.write(path, image.save_png_to_buffer())
	if error != OK:
		printerr("Cannot write the screenshot %s: %s." % [path, error_string(error)])
	return error
