@tool
extends RefCounted
## GANode3D nodes of the edited scene: the scene of a selected one is shown in the dock and around the node, as long as it
## is selected; a click on what one draws selects it.

const PlaygroundDock := preload("playground_dock.gd")
const Picking := preload("../playground/view/picking.gd")
const SceneDrawing := preload("../playground/view/scene_drawing.gd")
const ViewPointer := preload("../playground/view/view_pointer.gd")

var _dock: PlaygroundDock
var _drawing: SceneDrawing
var _pointer: ViewPointer
# What the dock shows when no such node is selected; null while it does.
var _own_scene: GAScene
var _own_path := ""
var _own_saved_text := ""
var _node: GANode3D
# Between a press that selected something and its release.
var _is_pressed := false


func _init(dock: PlaygroundDock, drawing: SceneDrawing, pointer: ViewPointer) -> void:
	_dock = dock
	_drawing = drawing
	_pointer = pointer
	EditorInterface.get_selection().selection_changed.connect(_on_selection_changed)
	_on_selection_changed()


func stop() -> void:
	EditorInterface.get_selection().selection_changed.disconnect(_on_selection_changed)
	_show(null)


## True if the event was for a node of the edited scene.
func handle_click(event: InputEvent, camera: Camera3D) -> bool:
	var button := event as InputEventMouseButton
	if button == null or button.button_index != MOUSE_BUTTON_LEFT:
		return false
	if not button.pressed:
		var was_pressed := _is_pressed
		_is_pressed = false
		return was_pressed
	var may_take: bool = _pointer.may_take.call(camera, button.position)
	var node := Picking.find_object(_edited_nodes(), camera, button.position, false) if may_take else null
	if node == null:
		return false
	_is_pressed = true
	_select(node, button.is_command_or_control_pressed() or button.shift_pressed)
	return true


static func _select(node: Node, adding_to_others: bool) -> void:
	var selection := EditorInterface.get_selection()
	if adding_to_others and selection.get_selected_nodes().has(node):
		selection.remove_node(node)
		return
	if not adding_to_others:
		selection.clear()
	selection.add_node(node)
	EditorInterface.edit_node(node)


static func _edited_nodes() -> Array[GANode3D]:
	var nodes: Array[GANode3D] = []
	var root := EditorInterface.get_edited_scene_root()
	if root != null:
		if root is GANode3D:
			nodes.append(root as GANode3D)
		for node in root.find_children("*", "GANode3D"):
			nodes.append(node as GANode3D)
	return nodes


func _on_selection_changed() -> void:
	var chosen: GANode3D = null
	for node in EditorInterface.get_selection().get_selected_nodes():
		var drawn := node as GANode3D
		if drawn != null and drawn.scene != null and drawn.scene.has_entry(drawn.entry):
			chosen = drawn
	if chosen != _node or (chosen != null and chosen.scene != _dock.document.scene):
		_show(chosen)


func _show(node: GANode3D) -> void:
	if is_instance_valid(_node) and _node.tree_exiting.is_connected(_show):
		_node.tree_exiting.disconnect(_show)
	_node = node
	_pointer.other_nodes.clear()
	_drawing.left_out = PackedStringArray()
	if node == null:
		_show_own()
		_drawing.transform = Transform3D.IDENTITY
		return
	var document := _dock.document
	if node.scene != document.scene:
		if _own_scene == null:
			_own_scene = document.scene
			_own_path = document.path
			_own_saved_text = document.get_saved_text()
		document.show_scene(node.scene, node.scene.resource_path)
	_pointer.other_nodes.append(node)
	_drawing.left_out = PackedStringArray([node.entry])
	node.tree_exiting.connect(_show.bind(null))
	follow()
	_dock.panel.select(node.entry)


## The drawing around the selected node moves with it.
func follow() -> void:
	if is_instance_valid(_node) and _node.is_inside_tree() and _drawing.global_transform != _node.global_transform:
		_drawing.global_transform = _node.global_transform


func _show_own() -> void:
	if _own_scene == null:
		return
	var document := _dock.document
	var own := _own_scene
	_own_scene = null
	var current := own.document
	own.document = _own_saved_text
	document.show_scene(own, _own_path)
	own.document = current
