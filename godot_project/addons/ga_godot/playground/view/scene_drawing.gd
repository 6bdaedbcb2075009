@tool
extends Node3D
## Draws the entries of a scene: a node for each, in the colour of its kind unless the entry has one, and with lines of
## the usual width unless its attribute "line_width" tells another one in pixels.

const PlaygroundStyle := preload("../theme/playground_style.gd")

## By what Multivector.classify tells; all else has the last.
const COLORS: Dictionary[StringName, Color] = {
	&"point": Color(0.98, 0.45, 0.45),
	&"flat_point": Color(0.98, 0.45, 0.45),
	&"point_pair": Color(0.95, 0.55, 0.75),
	&"line": Color(1.0, 0.75, 0.35),
	&"circle": Color(0.55, 0.85, 0.45),
	&"plane": Color(0.6, 0.7, 0.85),
	&"sphere": Color(0.35, 0.7, 1.0),
	&"motor": Color(0.8, 0.6, 1.0),
	&"rotor": Color(0.8, 0.6, 1.0),
	&"translator": Color(0.8, 0.6, 1.0),
	&"dilator": Color(0.8, 0.6, 1.0),
}
const OTHER_COLOR := Color(0.35, 0.8, 0.8)
## Line widths in pixels at the usual scale, and what is added to them.
const LINE_WIDTH := 2.0
const SELECTED_EXTRA := 1.0
const HOVERED_EXTRA := 1.6
const THINNEST := 0.25
const THICKEST := 20.0

## Before a light background nothing is lighter.
const LIGHTEST := 0.48

var scene: GAScene:
	set = set_scene
## Whether what is behind the objects is light; colours of kinds are then darker. An entry with its own keeps it.
var on_light := false:
	set = set_on_light
## Entries that something else draws in the same place.
var left_out := PackedStringArray():
	set = set_left_out

var _nodes: Dictionary[String, GANode3D] = {}
var _hovered := ""
var _selected := PackedStringArray()


func set_scene(new_scene: GAScene) -> void:
	if scene == new_scene:
		return
	if scene != null:
		scene.changed.disconnect(_draw)
	scene = new_scene
	for entry in _nodes:
		_nodes[entry].queue_free()
	_nodes.clear()
	if scene != null:
		scene.changed.connect(_draw)
		_draw()


func set_on_light(value: bool) -> void:
	on_light = value
	if scene != null:
		_draw()


func set_left_out(entries: PackedStringArray) -> void:
	left_out = entries
	for entry in _nodes:
		_nodes[entry].visible = not left_out.has(entry)


## The node that draws an entry, or null.
func find_node_of(entry: String) -> GANode3D:
	return _nodes.get(entry)


func get_nodes() -> Array[GANode3D]:
	return Array(_nodes.values(), TYPE_OBJECT, &"GANode3D", null)


## Draws the one under the mouse, and those that are selected, with wider lines.
func emphasize(hovered: String, selected: PackedStringArray) -> void:
	_hovered = hovered
	_selected = selected
	for entry in _nodes:
		if scene.has_entry(entry):
			_set_width(entry)


static func color_of(of_scene: GAScene, entry: String) -> Color:
	var own: String = of_scene.get_entry_attribute(entry, "color")
	if not own.is_empty():
		return Color.from_string(own, OTHER_COLOR)
	var value := of_scene.get_value(entry)
	if value == null:
		return OTHER_COLOR
	var is_dual: bool = of_scene.get_entry_attribute(entry, "ipns")
	return COLORS.get(value.classify(is_dual)["kind"], OTHER_COLOR)


static func width_of(of_scene: GAScene, entry: String) -> float:
	var own: Variant = of_scene.get_entry_attribute(entry, "line_width")
	return clampf(own, THINNEST, THICKEST) if own is float else LINE_WIDTH


func _draw() -> void:
	for entry: String in _nodes.keys():
		if not scene.has_entry(entry):
			_nodes[entry].queue_free()
			_nodes.erase(entry)
	for entry in scene.get_names():
		if not _nodes.has(entry):
			_nodes[entry] = _make_node(entry)
		var color := _on_background(color_of(scene, entry))
		# While one is dragged all others stay as they are.
		if _nodes[entry].color != color:
			_nodes[entry].color = color
		_set_width(entry)
		var has_label: bool = scene.get_entry_attribute(entry, "label")
		if _nodes[entry].show_label != has_label:
			_nodes[entry].show_label = has_label


func _on_background(color: Color) -> Color:
	# As labels measure it, which then have a light outline.
	var lightness := 0.3 * color.r + 0.59 * color.g + 0.11 * color.b
	var factor := LIGHTEST / maxf(lightness, LIGHTEST) if on_light else 1.0
	return Color(color.r * factor, color.g * factor, color.b * factor, color.a)


func _set_width(entry: String) -> void:
	var width := _width_of(entry)
	if not is_equal_approx(_nodes[entry].line_width, width):
		_nodes[entry].line_width = width


func _width_of(entry: String) -> float:
	var extra := SELECTED_EXTRA if _selected.has(entry) else 0.0
	return (
		(width_of(scene, entry) + (HOVERED_EXTRA if entry == _hovered else extra))
		* PlaygroundStyle.scale()
	)


func _make_node(entry: String) -> GANode3D:
	var node := GANode3D.new()
	node.scene = scene
	node.entry = entry
	node.line_width = _width_of(entry)
	node.visible = not left_out.has(entry)
	add_child(node)
	return node
