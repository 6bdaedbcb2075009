@tool
extends RefCounted
## The panel's theme in a running game, dark or light. It contains the items of the editor's theme
## that the panel uses, and the styles of its controls.

const ThemeIcons := preload("theme_icons.gd")

const FONT_SIZE := 14
const SMALL_RADIUS := 4
const RADIUS := 6
## Text fields and lists.
const BOXES: Array[StringName] = [&"LineEdit", &"TextEdit", &"Tree", &"ItemList"]
const BUTTONS: Array[StringName] = [
	&"Button", &"OptionButton", &"MenuButton", &"CheckBox", &"CheckButton"
]


## Colors by purpose. Translucent ones are drawn over any surface.
static func palette(light: bool) -> Dictionary[StringName, Color]:
	if light:
		return {
			&"base": Color("f4f5f8"),
			&"raised": Color("ffffff"),
			&"field": Color("ffffff"),
			&"border": Color("d3d7df"),
			&"text": Color("232936"),
			&"faint": Color("232936", 0.05),
			&"hover": Color("232936", 0.07),
			&"accent": Color("1f6fd1"),
			&"selected": Color("1f6fd1", 0.14),
			&"error": Color("c3283f"),
			&"view": Color("e9ebf0"),
		}
	return {
		&"base": Color("191d25"),
		&"raised": Color("232934"),
		&"field": Color("11141a"),
		&"border": Color("343b49"),
		&"text": Color("d8dde6"),
		&"faint": Color("ffffff", 0.06),
		&"hover": Color("ffffff", 0.08),
		&"accent": Color("6aaeff"),
		&"selected": Color("6aaeff", 0.17),
		&"error": Color("ff7b85"),
		&"view": Color("12151b"),
	}


static func make(light: bool) -> Theme:
	var colors := palette(light)
	var theme := Theme.new()
	theme.default_font_size = FONT_SIZE
	ThemeIcons.add_to(
		theme,
		{
			"TEXT": colors[&"text"],
			"ACCENT": colors[&"accent"],
			"BASE": colors[&"base"],
			"ERROR": colors[&"error"]
		}
	)
	_set_texts(theme, colors)
	_set_boxes(theme, colors)
	_set_buttons(theme, colors)
	_set_windows(theme, colors)
	_set_sliders(theme, colors)
	_set_foldables(theme, colors)
	return theme


static func _set_texts(theme: Theme, colors: Dictionary[StringName, Color]) -> void:
	theme.set_color(&"font_color", &"Editor", colors[&"text"])
	theme.set_color(&"error_color", &"Editor", colors[&"error"])
	theme.set_color(&"accent_color", &"Editor", colors[&"accent"])
	for type: StringName in [
		&"Label", &"LineEdit", &"TextEdit", &"Tree", &"ItemList", &"TooltipLabel"
	]:
		theme.set_color(&"font_color", type, colors[&"text"])
	theme.set_color(&"default_color", &"RichTextLabel", colors[&"text"])
	for type: StringName in [&"Tree", &"ItemList"]:
		for item: StringName in [
			&"font_hovered_color", &"font_selected_color", &"font_hovered_selected_color"
		]:
			theme.set_color(item, type, colors[&"text"])
		theme.set_color(&"guide_color", type, Color.TRANSPARENT)
	theme.set_color(&"drop_position_color", &"Tree", colors[&"accent"])
	theme.set_color(&"font_selected_color", &"LineEdit", colors[&"text"])
	theme.set_color(&"font_uneditable_color", &"LineEdit", Color(colors[&"text"], 0.6))
	theme.set_color(&"font_placeholder_color", &"LineEdit", Color(colors[&"text"], 0.5))
	theme.set_color(&"caret_color", &"LineEdit", colors[&"text"])
	theme.set_color(&"clear_button_color", &"LineEdit", colors[&"text"])
	theme.set_color(&"selection_color", &"LineEdit", Color(colors[&"accent"], 0.35))
	for color: StringName in [&"folder_icon_color", &"file_icon_color"]:
		theme.set_color(
			color,
			&"FileDialog",
			colors[&"accent"] if color == &"folder_icon_color" else colors[&"text"]
		)
	theme.set_type_variation(&"HeaderSmall", &"Label")
	theme.set_font_size(&"font_size", &"HeaderSmall", FONT_SIZE - 1)


static func _set_boxes(theme: Theme, colors: Dictionary[StringName, Color]) -> void:
	for type in BOXES:
		theme.set_stylebox(&"panel", type, _box(colors[&"field"], colors[&"border"], 6, 4))
		theme.set_stylebox(&"normal", type, _box(colors[&"field"], colors[&"border"], 6, 3))
		theme.set_stylebox(&"read_only", type, _box(colors[&"faint"], colors[&"border"], 6, 3))
		theme.set_stylebox(&"focus", type, _outline(colors[&"accent"]))
	for type: StringName in [&"Tree", &"ItemList"]:
		for style: StringName in [
			&"selected", &"selected_focus", &"hovered_selected", &"hovered_selected_focus"
		]:
			theme.set_stylebox(
				style, type, _box(colors[&"selected"], Color.TRANSPARENT, 4, 2, SMALL_RADIUS)
			)
		theme.set_stylebox(
			&"hovered", type, _box(colors[&"hover"], Color.TRANSPARENT, 4, 2, SMALL_RADIUS)
		)
	theme.set_stylebox(
		&"panel", &"PanelContainer", _box(colors[&"base"], Color.TRANSPARENT, 8, 8, 0)
	)
	theme.set_stylebox(&"panel", &"Panel", _box(colors[&"base"], Color.TRANSPARENT, 0, 0, 0))
	theme.set_stylebox(&"panel", &"ScrollContainer", StyleBoxEmpty.new())
	theme.set_stylebox(
		&"split_bar_background",
		&"SplitContainer",
		_box(colors[&"base"], Color.TRANSPARENT, 0, 0, 0)
	)
	for type: StringName in [&"HSeparator", &"VSeparator"]:
		var line := StyleBoxLine.new()
		line.color = colors[&"border"]
		line.vertical = type == &"VSeparator"
		theme.set_stylebox(&"separator", type, line)


static func _set_buttons(theme: Theme, colors: Dictionary[StringName, Color]) -> void:
	theme.set_type_variation(&"FlatButton", &"Button")
	for type: StringName in BUTTONS + [&"FlatButton"]:
		var is_flat := type in [&"MenuButton", &"FlatButton", &"CheckBox", &"CheckButton"]
		var margin := 5 if type == &"FlatButton" else 8
		var fill := Color.TRANSPARENT if is_flat else colors[&"raised"]
		var border := Color.TRANSPARENT if is_flat else colors[&"border"]
		theme.set_stylebox(&"normal", type, _box(fill, border, margin, 4))
		theme.set_stylebox(&"disabled", type, _box(fill, border, margin, 4))
		theme.set_stylebox(
			&"hover",
			type,
			_box(
				colors[&"hover"] if is_flat else colors[&"raised"].lerp(colors[&"text"], 0.08),
				border,
				margin,
				4
			)
		)
		theme.set_stylebox(&"pressed", type, _box(colors[&"selected"], border, margin, 4))
		theme.set_stylebox(&"hover_pressed", type, _box(colors[&"selected"], border, margin, 4))
		theme.set_stylebox(&"focus", type, _outline(colors[&"accent"]))
		for state: String in ["", "hover_", "pressed_", "hover_pressed_", "focus_"]:
			theme.set_color("font_%scolor" % state, type, colors[&"text"])
		theme.set_color(&"font_disabled_color", type, Color(colors[&"text"], 0.35))
		theme.set_color(&"icon_disabled_color", type, Color(1, 1, 1, 0.35))
	theme.set_constant(&"arrow_margin", &"OptionButton", 6)
	for type: StringName in [&"CheckBox", &"CheckButton"]:
		for state: StringName in [&"pressed", &"hover_pressed"]:
			theme.set_stylebox(state, type, theme.get_stylebox(&"normal", type))


static func _set_windows(theme: Theme, colors: Dictionary[StringName, Color]) -> void:
	var menu := _box(colors[&"raised"], colors[&"border"], 6, 6)
	menu.shadow_color = Color(0, 0, 0, 0.22)
	menu.shadow_size = 8
	theme.set_stylebox(&"panel", &"PopupMenu", menu)
	theme.set_stylebox(&"panel", &"PopupPanel", menu)
	theme.set_stylebox(
		&"panel", &"TooltipPanel", _box(colors[&"raised"], colors[&"border"], 8, 4, SMALL_RADIUS)
	)
	theme.set_stylebox(
		&"hover", &"PopupMenu", _box(colors[&"selected"], Color.TRANSPARENT, 0, 0, SMALL_RADIUS)
	)
	var separator := StyleBoxLine.new()
	separator.color = colors[&"border"]
	theme.set_stylebox(&"separator", &"PopupMenu", separator)
	theme.set_constant(&"v_separation", &"PopupMenu", 7)
	theme.set_constant(&"item_start_padding", &"PopupMenu", 8)
	theme.set_constant(&"item_end_padding", &"PopupMenu", 8)
	for color: StringName in [&"font_color", &"font_hover_color"]:
		theme.set_color(color, &"PopupMenu", colors[&"text"])
	for color: StringName in [
		&"font_accelerator_color", &"font_disabled_color", &"font_separator_color"
	]:
		theme.set_color(color, &"PopupMenu", Color(colors[&"text"], 0.45))
	var frame := _box(colors[&"base"], colors[&"border"], 10, 10)
	frame.expand_margin_top = 32
	frame.shadow_color = Color(0, 0, 0, 0.3)
	frame.shadow_size = 14
	for style: StringName in [&"embedded_border", &"embedded_unfocused_border"]:
		theme.set_stylebox(style, &"Window", frame)
	theme.set_color(&"title_color", &"Window", colors[&"text"])
	theme.set_constant(&"title_height", &"Window", 32)
	theme.set_stylebox(
		&"panel", &"AcceptDialog", _box(colors[&"base"], Color.TRANSPARENT, 12, 12, 0)
	)


static func _set_sliders(theme: Theme, colors: Dictionary[StringName, Color]) -> void:
	for type: StringName in [&"HScrollBar", &"VScrollBar"]:
		theme.set_stylebox(&"scroll", type, _box(Color.TRANSPARENT, Color.TRANSPARENT, 3, 3, 3))
		theme.set_stylebox(
			&"scroll_focus", type, _box(Color.TRANSPARENT, Color.TRANSPARENT, 3, 3, 3)
		)
		theme.set_stylebox(
			&"grabber", type, _box(Color(colors[&"text"], 0.25), Color.TRANSPARENT, 3, 3, 3)
		)
		theme.set_stylebox(
			&"grabber_highlight",
			type,
			_box(Color(colors[&"text"], 0.4), Color.TRANSPARENT, 3, 3, 3)
		)
		theme.set_stylebox(
			&"grabber_pressed", type, _box(colors[&"accent"], Color.TRANSPARENT, 3, 3, 3)
		)
	theme.set_stylebox(
		&"slider", &"HSlider", _box(Color(colors[&"text"], 0.15), Color.TRANSPARENT, 2, 2, 2)
	)
	theme.set_stylebox(
		&"grabber_area", &"HSlider", _box(Color(colors[&"accent"], 0.7), Color.TRANSPARENT, 2, 2, 2)
	)
	theme.set_stylebox(
		&"grabber_area_highlight", &"HSlider", _box(colors[&"accent"], Color.TRANSPARENT, 2, 2, 2)
	)


static func _set_foldables(theme: Theme, colors: Dictionary[StringName, Color]) -> void:
	var type := &"FoldableContainer"
	theme.set_stylebox(&"panel", type, _box(colors[&"faint"], Color.TRANSPARENT, 6, 6, RADIUS))
	for style: StringName in [&"title_panel", &"title_collapsed_panel"]:
		theme.set_stylebox(style, type, _box(Color.TRANSPARENT, Color.TRANSPARENT, 4, 4))
	for style: StringName in [&"title_hover_panel", &"title_collapsed_hover_panel"]:
		theme.set_stylebox(style, type, _box(colors[&"hover"], Color.TRANSPARENT, 4, 4))
	theme.set_stylebox(&"focus", type, StyleBoxEmpty.new())
	for color: StringName in [&"font_color", &"hover_font_color", &"collapsed_font_color"]:
		theme.set_color(color, type, colors[&"text"])


static func _box(
	fill: Color, border: Color, horizontal: int, vertical: int, radius := RADIUS
) -> StyleBoxFlat:
	var box := StyleBoxFlat.new()
	box.bg_color = fill
	box.border_color = border
	box.set_border_width_all(1 if border.a > 0.0 else 0)
	box.set_corner_radius_all(radius)
	for side: Side in [SIDE_LEFT, SIDE_RIGHT]:
		box.set_content_margin(side, horizontal)
	for side: Side in [SIDE_TOP, SIDE_BOTTOM]:
		box.set_content_margin(side, vertical)
	return box


static func _outline(color: Color) -> StyleBoxFlat:
	var box := _box(Color.TRANSPARENT, color, 0, 0)
	box.draw_center = false
	return box
