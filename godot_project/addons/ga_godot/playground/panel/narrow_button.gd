@tool
extends RefCounted
## Gives icon buttons narrow margins, so that a row of them fits a narrow dock.

const PlaygroundStyle := preload("../theme/playground_style.gd")

## Margin to the left and right of the icon, in pixels.
const MARGIN := 4.0


## Call this whenever the theme changes.
static func apply(button: Button) -> void:
	for state: StringName in [&"normal", &"hover", &"pressed", &"hover_pressed", &"disabled"]:
		button.remove_theme_stylebox_override(state)
		var style: StyleBox = button.get_theme_stylebox(state).duplicate()
		for side: Side in [SIDE_LEFT, SIDE_RIGHT]:
			style.set_content_margin(side, MARGIN * PlaygroundStyle.scale())
		button.add_theme_stylebox_override(state, style)
