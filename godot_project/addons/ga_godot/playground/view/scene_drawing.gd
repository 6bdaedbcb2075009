@tool
extends Node3D
## Draws each entry of a scene with a node, in the entry's color or, by default, that of its kind.
## The attribute "line_width" of an entry sets its line width in pixels.

const PlaygroundStyle := preload("../theme/playground_style.gd")

## Colors by the kind that Multivector.classify() returns; OTHER_COLOR for all others.
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
## Line widths in pixels, to be multiplied by the editor's scale.
const LINE_WIDTH := 2.0
const SELECTED_EXTRA := 1.0
const HOVERED_EXTRA := 1.6
const MIN_LINE_WIDTH := 0.25
const MAX_LINE_WIDTH := 20.0

## Maximum lightness of colors on a light background.
const MAX_LIGHTNESS := 0.48

var scene: GAScene:
	set = set_scene
## Whether the background is light, which needs darker colors.
var on_light := false:
	set = set_on_light
## Entries that are not drawn, because other nodes draw them with the same transform.
var excluded := PackedStringArray():
	set = set_excluded

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


func set_excluded(entries: PackedStringArray) -> void:
	excluded = entries
	for entry in _nodes:
		_nodes[entry].visible = not excluded.has(entry)


## The node that draws an entry, or null.
func find_node_of(entry: String) -> GANode3D:
	return _nodes.get(entry)


func get_nodes() -> Array[GANode3D]:
	return Array(_nodes.values(), TYPE_OBJECT, &"GANode3D", null)


## Widens the lines of the entry under the mouse and of selected ones.
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
	return clampf(own, MIN_LINE_WIDTH, MAX_LINE_WIDTH) if own is float else LINE_WIDTH


func _draw() -> void:
	for entry: String in _nodes.keys():
		if not scene.has_entry(entry):
			_nodes[entry].queue_free()
			_nodes.erase(entry)
	for entry in scene.get_names():
		if not _nodes.has(entry):
			_nodes[entry] = _make_node(entry)
		var color := _on_background(color_of(scene, entry))
		# Avoids redrawing entries that did not change, which matters during a drag.
		if _nodes[entry].color != color:
			_nodes[entry].color = color
		_set_width(entry)
		var has_label: bool = scene.get_entry_attribute(entry, "label")
		if _nodes[entry].show_label != has_label:
			_nodes[entry].show_label = has_label


func _on_background(color: Color) -> Color:
	# The formula by which labels choose between a light and a dark outline.
	var lightness := 0.3 * color.r + 0.59 * color.g + 0.11 * color.b
	var factor := MAX_LIGHTNESS / maxf(lightness, MAX_LIGHTNESS) if on_light else 1.0
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
	node.visible = not excluded.has(entry)
	add_child(node)
	return node
