@tool
extends ColorPickerButton
## The color of an entry. The drawing follows while the picker is open; closing it adds one action
## to the history.

const PlaygroundDocument := preload("../document/playground_document.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")
const SceneDrawing := preload("../view/scene_drawing.gd")

const WIDTH := 14.0

var _entry := ""
var _document: PlaygroundDocument


func _init(document: PlaygroundDocument) -> void:
	name = "Color"
	_document = document
	tooltip_text = "Choose the color of the object."
	focus_mode = Control.FOCUS_NONE
	size_flags_vertical = Control.SIZE_SHRINK_CENTER
	var side := WIDTH * PlaygroundStyle.scale()
	custom_minimum_size = Vector2(side, side)
	for style: StringName in [
		&"normal", &"hover", &"pressed", &"focus", &"hover_pressed", &"disabled"
	]:
		add_theme_stylebox_override(style, StyleBoxEmpty.new())
	pressed.connect(_document.begin_gesture)
	color_changed.connect(_on_color_changed)
	popup_closed.connect(func() -> void: _document.end_gesture("Set Color of %s" % _entry))


func show_entry(entry: String) -> void:
	_entry = entry
	color = SceneDrawing.color_of(_document.scene, entry)


func _on_color_changed(chosen: Color) -> void:
	_document.scene.set_entry_attribute(_entry, "color", "#" + chosen.to_html(chosen.a < 1.0))
