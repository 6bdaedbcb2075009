@tool
extends RefCounted
## Connects the dock to the GANode3D nodes of the edited scene. While one is selected, the dock and
## the viewports show its GAScene. A click on the drawing of a node selects it.

const PlaygroundDock := preload("playground_dock.gd")
const Picking := preload("../playground/view/picking.gd")
const SceneDrawing := preload("../playground/view/scene_drawing.gd")
const ViewPointer := preload("../playground/view/view_pointer.gd")
const ViewRay := preload("../playground/view/view_ray.gd")

var _dock: PlaygroundDock
var _drawing: SceneDrawing
var _pointer: ViewPointer
# The dock's own scene while the dock shows the scene of a selected node; otherwise null.
var _own_scene: GAScene
var _own_path := ""
var _own_saved_text := ""
var _node: GANode3D
# Set while this object switches the scene of the dock.
var _is_switching := false
# Set between a press that selected a node and its release.
var _is_pressed := false
var _tree := Engine.get_main_loop() as SceneTree


func _init(dock: PlaygroundDock, drawing: SceneDrawing, pointer: ViewPointer) -> void:
	_dock = dock
	_drawing = drawing
	_pointer = pointer
	EditorInterface.get_selection().selection_changed.connect(_on_selection_changed)
	_dock.document.scene_switched.connect(_on_scene_switched)
	_tree.node_added.connect(_on_node_added_or_removed)
	_tree.node_removed.connect(_on_node_added_or_removed)
	_on_selection_changed()


func stop() -> void:
	_tree.node_added.disconnect(_on_node_added_or_removed)
	_tree.node_removed.disconnect(_on_node_added_or_removed)
	_dock.document.scene_switched.disconnect(_on_scene_switched)
	EditorInterface.get_selection().selection_changed.disconnect(_on_selection_changed)
	_show(null)


## Switches to the dock's own document, calls `action`, and switches back. Used for saving.
func with_own_document(action: Callable) -> void:
	var node := _node
	_show(null)
	action.call()
	_show(node)


## Returns whether the event was used to select a node of the edited scene.
func handle_click(event: InputEvent, camera: Camera3D) -> bool:
	var button := event as InputEventMouseButton
	if button == null or button.button_index != MOUSE_BUTTON_LEFT:
		return false
	if not button.pressed:
		var was_pressed := _is_pressed
		_is_pressed = false
		return was_pressed
	var can_pick: bool = _pointer.can_pick.call(camera, button.position)
	var node := (
		Picking.find_object(_edited_nodes(), camera, button.position, false) if can_pick else null
	)
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
	else:
		_exclude_drawn()


func _show(node: GANode3D) -> void:
	if is_instance_valid(_node) and _node.tree_exiting.is_connected(_show):
		_node.tree_exiting.disconnect(_show)
	_node = node
	if node == null:
		_show_own()
		_drawing.transform = Transform3D.IDENTITY
		_exclude_drawn()
		return
	var document := _dock.document
	if node.scene != document.scene:
		if _own_scene == null:
			_own_scene = document.scene
			_own_path = document.path
			_own_saved_text = document.get_saved_text()
		_is_switching = true
		document.show_scene(node.scene, node.scene.resource_path)
		_is_switching = false
	node.tree_exiting.connect(_show.bind(null))
	follow()
	_exclude_drawn()
	_dock.panel.select(node.entry)


## Excludes entries that nodes of the edited scene already draw with the same transform.
func _exclude_drawn() -> void:
	if not _drawing.is_inside_tree():
		return
	_pointer.other_nodes.clear()
	var entries := PackedStringArray()
	for node in _edited_nodes():
		var is_same := (
			node == _node
			or (
				node.is_inside_tree()
				and node.is_visible_in_tree()
				and node.global_transform == _drawing.global_transform
			)
		)
		if is_same and node.scene == _dock.document.scene:
			_pointer.other_nodes.append(node)
			entries.append(node.entry)
	if entries != _drawing.excluded:
		_drawing.excluded = entries


func _on_node_added_or_removed(node: Node) -> void:
	if node is GANode3D and node.get_parent() != _drawing:
		_exclude_drawn.call_deferred()


## Moves the drawing with the selected node.
func follow() -> void:
	if not is_instance_valid(_node) or not _node.is_inside_tree():
		return
	var space := _node.global_transform
	if _drawing.global_transform != space and not ViewRay.is_degenerate(space):
		_drawing.global_transform = space


func _show_own() -> void:
	if _own_scene == null:
		return
	var document := _dock.document
	var own := _own_scene
	_own_scene = null
	var current := own.document
	_is_switching = true
	own.document = _own_saved_text
	document.show_scene(own, _own_path)
	own.document = current
	_is_switching = false


# A document that the user opens while a node is selected replaces the dock's own document, which
# may have unsaved changes. The node keeps its scene.
func _on_scene_switched() -> void:
	if not _is_switching and _own_scene != null and _dock.document.scene != _node.scene:
		_replace_own.call_deferred(_dock.document.scene, _dock.document.path)
	else:
		_exclude_drawn()


func _replace_own(scene: GAScene, path: String) -> void:
	_show(null)
	_dock.panel.file_menu.confirm_discard(func() -> void: _dock.document.show_scene(scene, path))
