@tool
extends RefCounted
## Textures of SVG. From Godot 4.5, the engine redraws them for the resolution of the screen.

const ENGINE_CLASS := &"DPITexture"


static func make(source: String, scale := 1.0) -> Texture2D:
	if ClassDB.class_exists(ENGINE_CLASS):
		return ClassDB.class_call_static(ENGINE_CLASS, &"create_from_string", source, scale)
	return make_image(source, scale)


## As make(), in every version without the redrawing.
static func make_image(source: String, scale := 1.0) -> Texture2D:
	var image := Image.new()
	image.load_svg_from_string(source, scale)
	return ImageTexture.create_from_image(image)
