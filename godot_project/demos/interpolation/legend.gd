extends HBoxContainer
## The legend of the paths; a click shows or hides a path.

signal path_toggled(mode: int, shown: bool)

const Modes := preload("res://addons/ga_godot/playground/lab/interpolation_modes.gd")


func _init() -> void:
	alignment = BoxContainer.ALIGNMENT_CENTER
	add_theme_constant_override(&"separation", 14)


func _ready() -> void:
	for mode in Modes.COUNT:
		var box := CheckBox.new()
		box.text = Modes.TITLES[mode]
		box.button_pressed = true
		box.tooltip_text = "Show or hide this path."
		box.focus_mode = Control.FOCUS_NONE
		for state: StringName in [
			&"font_color", &"font_hover_color", &"font_pressed_color", &"font_hover_pressed_color"
		]:
			box.add_theme_color_override(state, Modes.COLORS[mode])
		box.toggled.connect(_on_toggled.bind(mode))
		add_child(box)


func _on_toggled(shown: bool, mode: int) -> void:
	path_toggled.emit(mode, shown)
