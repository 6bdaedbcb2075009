@tool
extends RefCounted
## Icons for the theme of a running game: replacements for the editor's icons, and icons of
## controls.

const SvgTexture := preload("svg_texture.gd")

const SIZE := 16
# gdlint: disable=max-line-length
## Contents of <svg>. TEXT, ACCENT, BASE and ERROR stand for colors of the palette.
const EDITOR_ICONS: Dictionary[StringName, String] = {
	&"GuiVisibilityVisible":
	'<path d="M1 8c2.5-5.4 11.5-5.4 14 0-2.5 5.4-11.5 5.4-14 0z" fill="none" stroke="ACCENT" stroke-width="1.6" stroke-linejoin="round"/><circle cx="8" cy="8" r="2.4" fill="ACCENT"/>',
	&"GuiVisibilityHidden":
	'<path d="M1.5 7c2.8 4.2 10.2 4.2 13 0M4 9.6 2.8 11.8M8 10.3V13M12 9.6l1.2 2.2" fill="none" stroke="TEXT" stroke-opacity="0.55" stroke-width="1.6" stroke-linecap="round"/>',
	&"GuiTabMenuHl":
	'<g fill="TEXT"><circle cx="8" cy="3" r="1.6"/><circle cx="8" cy="8" r="1.6"/><circle cx="8" cy="13" r="1.6"/></g>',
	&"StatusError":
	'<circle cx="8" cy="8" r="6.5" fill="ERROR"/><path d="m5.7 5.7 4.6 4.6M10.3 5.7l-4.6 4.6" stroke="BASE" stroke-width="1.7" stroke-linecap="round"/>',
	&"StatusWarning":
	'<path d="M8 1.8 15 14H1z" fill="#e8b339" stroke="#e8b339" stroke-linejoin="round"/><path d="M8 6v4m0 2v.2" stroke="BASE" stroke-width="1.7" stroke-linecap="round"/>',
	&"Play": '<path d="M4 2.5v11L13 8z" fill="TEXT" stroke="TEXT" stroke-linejoin="round"/>',
	&"Pause": '<path d="M5 3v10M11 3v10" stroke="TEXT" stroke-width="2.8" stroke-linecap="round"/>',
	&"Stop": '<rect x="3" y="3" width="10" height="10" rx="1.5" fill="TEXT"/>',
	&"Loop":
	'<path d="M3 8a5 5 0 0 1 9-3M13 8a5 5 0 0 1-9 3" fill="none" stroke="TEXT" stroke-width="1.7" stroke-linecap="round"/><path d="M13.5 2v4h-4zM2.5 14v-4h4z" fill="TEXT"/>',
	&"PingPongLoop":
	'<path d="M3 8h10" stroke="TEXT" stroke-width="1.8"/><path d="M.8 8 5.5 4.5v7zM15.2 8l-4.7-3.5v7z" fill="TEXT"/>',
	&"Close":
	'<path d="m4 4 8 8m0-8-8 8" stroke="TEXT" stroke-width="1.8" stroke-linecap="round"/>',
	&"Add": '<path d="M8 3v10M3 8h10" stroke="TEXT" stroke-width="1.9" stroke-linecap="round"/>',
	&"Remove":
	'<path d="M3 4.5h10M6 4V2.5h4V4M4.2 6.5l.6 7h6.4l.6-7" fill="none" stroke="TEXT" stroke-width="1.5" stroke-linejoin="round" stroke-linecap="round"/>',
	&"Undo":
	'<path d="M4.5 6H10a3.7 3.7 0 0 1 0 7.4H6" fill="none" stroke="TEXT" stroke-width="1.7" stroke-linecap="round"/><path d="M1.5 6 6.5 2v8z" fill="TEXT"/>',
	&"Redo":
	'<path d="M11.5 6H6a3.7 3.7 0 0 0 0 7.4h4" fill="none" stroke="TEXT" stroke-width="1.7" stroke-linecap="round"/><path d="M14.5 6 9.5 2v8z" fill="TEXT"/>',
	&"Frame":
	'<path d="M2 5.5V2h3.5M10.5 2H14v3.5M14 10.5V14h-3.5M5.5 14H2v-3.5" fill="none" stroke="TEXT" stroke-width="1.6" stroke-linecap="round" stroke-linejoin="round"/><circle cx="8" cy="8" r="2.2" fill="TEXT"/>',
	&"Sun":
	'<circle cx="8" cy="8" r="3" fill="TEXT"/><path d="M8 1v1.8M8 13.2V15M1 8h1.8M13.2 8H15M3 3l1.3 1.3M11.7 11.7 13 13M3 13l1.3-1.3M11.7 4.3 13 3" stroke="TEXT" stroke-width="1.5" stroke-linecap="round"/>',
	&"Moon": '<path d="M13.8 9.7A6.2 6.2 0 0 1 6.3 2.2a6.2 6.2 0 1 0 7.5 7.5z" fill="TEXT"/>',
}
const ARROW_DOWN := '<path d="m4 6 4 4.2L12 6" fill="none" stroke="TEXT" stroke-width="1.7" stroke-linecap="round" stroke-linejoin="round"/>'
const ARROW_RIGHT := '<path d="M6 4l4.2 4L6 12" fill="none" stroke="TEXT" stroke-width="1.7" stroke-linecap="round" stroke-linejoin="round"/>'
const BOX := '<rect x="2.5" y="2.5" width="11" height="11" rx="2.5" fill="none" stroke="TEXT" stroke-opacity="0.6" stroke-width="1.3"/>'
const CHECKED_BOX := '<rect x="2" y="2" width="12" height="12" rx="2.5" fill="ACCENT"/><path d="m4.8 8.2 2.3 2.3 4.2-4.8" fill="none" stroke="BASE" stroke-width="1.8" stroke-linecap="round" stroke-linejoin="round"/>'
const RING := '<circle cx="8" cy="8" r="5.5" fill="none" stroke="TEXT" stroke-opacity="0.6" stroke-width="1.3"/>'
const FILLED_RING := '<circle cx="8" cy="8" r="6" fill="ACCENT"/><circle cx="8" cy="8" r="2.3" fill="BASE"/>'
const GRABBER := '<circle cx="8" cy="8" r="5.5" fill="BASE" stroke="TEXT" stroke-width="1.6"/><circle cx="8" cy="8" r="2.4" fill="TEXT"/>'
const GRABBER_HIGHLIGHT := '<circle cx="8" cy="8" r="6" fill="BASE" stroke="ACCENT" stroke-width="1.8"/><circle cx="8" cy="8" r="2.8" fill="ACCENT"/>'
## Keys are type and name of the theme item.
const MARKS: Dictionary[String, String] = {
	"OptionButton/arrow": ARROW_DOWN,
	"FoldableContainer/expanded_arrow": ARROW_DOWN,
	"FoldableContainer/folded_arrow": ARROW_RIGHT,
	"FoldableContainer/folded_arrow_mirrored": ARROW_RIGHT,
	"PopupMenu/submenu": ARROW_RIGHT,
	"PopupMenu/checked": CHECKED_BOX,
	"PopupMenu/unchecked": BOX,
	"PopupMenu/radio_checked": FILLED_RING,
	"PopupMenu/radio_unchecked": RING,
	"CheckBox/checked": CHECKED_BOX,
	"CheckBox/unchecked": BOX,
	"CheckBox/radio_checked": FILLED_RING,
	"CheckBox/radio_unchecked": RING,
	"LineEdit/clear":
	'<path d="m5 5 6 6m0-6-6 6" stroke="TEXT" stroke-width="1.6" stroke-linecap="round" stroke-opacity="0.7"/>',
	"HSlider/grabber": GRABBER,
	"HSlider/grabber_highlight": GRABBER_HIGHLIGHT,
	"HSlider/grabber_disabled": GRABBER,
	"Window/close":
	'<path d="m4 4 8 8m0-8-8 8" stroke="TEXT" stroke-width="1.8" stroke-linecap="round"/>',
	"Window/close_pressed":
	'<path d="m4 4 8 8m0-8-8 8" stroke="ACCENT" stroke-width="1.8" stroke-linecap="round"/>',
	"Tree/arrow": ARROW_DOWN,
	"Tree/arrow_collapsed": ARROW_RIGHT,
	"Tree/select_arrow": ARROW_DOWN,
}
# gdlint: enable=max-line-length


## Adds all icons to a theme. Keys of `colors` are TEXT, ACCENT, BASE and ERROR.
static func add_to(theme: Theme, colors: Dictionary[String, Color]) -> void:
	for icon in EDITOR_ICONS:
		theme.set_icon(icon, &"EditorIcons", _draw(EDITOR_ICONS[icon], colors))
	for item in MARKS:
		theme.set_icon(item.get_slice("/", 1), item.get_slice("/", 0), _draw(MARKS[item], colors))


static func _draw(body: String, colors: Dictionary[String, Color]) -> Texture2D:
	for color in colors:
		body = body.replace(color, "#" + colors[color].to_html(false))
	return SvgTexture.make(
		(
			'<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d">%s</svg>'
			% [SIZE, SIZE, body]
		)
	)
