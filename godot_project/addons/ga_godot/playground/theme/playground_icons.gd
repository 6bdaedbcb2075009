@tool
extends RefCounted
## Icons that the editor does not have, drawn in the theme's color.

const PlaygroundStyle := preload("playground_style.gd")
const SvgTexture := preload("svg_texture.gd")

const SIZE := 16
# gdlint: disable=max-line-length
## Contents of <svg>. COLOR stands for the color of the theme's text.
const ICONS: Dictionary[StringName, String] = {
	&"swap":
	'<path d="M2 5.5h11M14 10.5H3" stroke="COLOR" stroke-width="1.6" stroke-linecap="round"/><path d="m10 1.8 5 3.7-5 3.7zM6 6.8l-5 3.7 5 3.7z" fill="COLOR"/>',
	&"pick":
	'<rect x="1.5" y="2" width="13" height="4" rx="1.2" fill="COLOR"/><rect x="1.5" y="9.5" width="13" height="4" rx="1.2" fill="COLOR"/>',
	&"point": '<circle cx="8" cy="8" r="3.5" fill="COLOR"/>',
	&"pair":
	'<path d="M4 12 12 4" stroke="COLOR" stroke-width="1.2" stroke-dasharray="1.5 1.5"/><circle cx="3.5" cy="12.5" r="2.5" fill="COLOR"/><circle cx="12.5" cy="3.5" r="2.5" fill="COLOR"/>',
	&"line": '<path d="M1 14 15 2" stroke="COLOR" stroke-width="2" stroke-linecap="round"/>',
	&"circle":
	'<ellipse cx="8" cy="8" rx="6.5" ry="6.5" fill="none" stroke="COLOR" stroke-width="2"/>',
	&"plane":
	'<path d="M4.5 4H15l-3.5 8H1z" fill="COLOR" fill-opacity="0.35" stroke="COLOR" stroke-width="1.6" stroke-linejoin="round"/>',
	&"sphere":
	'<circle cx="8" cy="8" r="6.4" fill="COLOR" fill-opacity="0.3" stroke="COLOR" stroke-width="1.5"/><path d="M1.6 8a6.4 2.4 0 0 0 12.8 0" fill="none" stroke="COLOR" stroke-width="1.3"/>',
	&"motor":
	'<path d="M3 13.5c-2-3 9-2.5 9-5.5S2 7.5 3.5 4.5C4.5 2.8 8 2.6 12 3" fill="none" stroke="COLOR" stroke-width="1.7" stroke-linecap="round"/><path d="m10.5.3 4.5 3-4.5 2.7z" fill="COLOR"/>',
	&"scalar":
	'<path d="M1 8h14" stroke="COLOR" stroke-width="2" stroke-linecap="round" stroke-opacity="0.6"/><circle cx="10" cy="8" r="3.5" fill="COLOR"/>',
	&"join":
	'<path d="M3.5 12.5 12.5 3.5" stroke="COLOR" stroke-width="2"/><circle cx="3.5" cy="12.5" r="2.5" fill="COLOR"/><circle cx="12.5" cy="3.5" r="2.5" fill="COLOR"/>',
	&"meet":
	'<path d="M2 3 14 13M2 13 14 3" stroke="COLOR" stroke-width="1.3" stroke-linecap="round" stroke-opacity="0.7"/><circle cx="8" cy="8" r="3" fill="COLOR"/>',
	&"intersect":
	'<path d="M8 4a5 5 0 0 1 0 8a5 5 0 0 1 0-8z" fill="COLOR"/><circle cx="5.5" cy="8" r="4.7" fill="none" stroke="COLOR" stroke-width="1.3"/><circle cx="10.5" cy="8" r="4.7" fill="none" stroke="COLOR" stroke-width="1.3"/>',
	&"project":
	'<path d="M1 13.5h14" stroke="COLOR" stroke-width="2" stroke-linecap="round"/><circle cx="8" cy="3.2" r="2.5" fill="COLOR"/><path d="M8 6v4" stroke="COLOR" stroke-width="1.5"/><path d="M5.2 8.8h5.6L8 12.3z" fill="COLOR"/>',
	&"reflect":
	'<path d="M8 1v14" stroke="COLOR" stroke-width="1.5" stroke-dasharray="2.5 1.5"/><path d="M6 4v9H1z" fill="COLOR"/><path d="M10.7 5.2v7.1h3.7z" fill="none" stroke="COLOR" stroke-width="1.3"/>',
	&"move":
	'<path d="M2 12C2.5 6 7 3.5 11 4" fill="none" stroke="COLOR" stroke-width="2" stroke-linecap="round"/><path d="m9.5.5 5.5 4-5.5 3z" fill="COLOR"/><circle cx="3" cy="12.5" r="2.2" fill="COLOR"/>',
	&"label":
	'<path d="M3.5 13 8 2.5 12.5 13M5 9.7h6" fill="none" stroke="COLOR" stroke-width="1.9" stroke-linecap="round" stroke-linejoin="round"/>',
	&"dual":
	'<path d="M8 1.5a6.5 6.5 0 0 0 0 13z" fill="COLOR"/><circle cx="8" cy="8" r="6.5" fill="none" stroke="COLOR" stroke-width="1.4"/>',
}
# gdlint: enable=max-line-length


## The icon for a control, in one of the colors of its theme.
static func make(icon: StringName, control: Control, color_name := &"font_color") -> Texture2D:
	var color := control.get_theme_color(color_name, &"Editor")
	var body := ICONS[icon].replace("COLOR", "#" + color.to_html(false))
	var source := (
		'<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d">%s</svg>'
		% [SIZE, SIZE, body]
	)
	return SvgTexture.make(source, PlaygroundStyle.scale())
