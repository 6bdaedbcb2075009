@tool
extends Node3D
## Draws the dock's document in the editor's 3D viewports and lets the user drag it by handles. Uses
## only events over the playground's objects, and does nothing while the dock is closed. A child of
## the plugin, so that its nodes are not part of the edited scene.

const HandleOverlay := preload("../playground/view/handle_overlay.gd")
const Picking := preload("../playground/view/picking.gd")
const SceneDrawing := preload("../playground/view/scene_drawing.gd")
const LabDrawing := preload("../playground/lab/lab_drawing.gd")
const ViewPointer := preload("../playground/view/view_pointer.gd")
const PlaygroundDock := preload("playground_dock.gd")
const SelectedNodes := preload("selected_nodes.gd")
const ViewportToolbar := preload("viewport_toolbar.gd")

const VIEWPORTS := 4
## The editor setting with the size of its transform gizmo, in pixels.
const MANIPULATOR_SIZE := "editors/3d/manipulator_gizmo_size"

var pointer: ViewPointer
var toolbar: ViewportToolbar

var _plugin: EditorPlugin
var _dock: PlaygroundDock
var _drawing := SceneDrawing.new()
var _nodes: SelectedNodes
var _views: Dictionary[Camera3D, Transform3D] = {}


func set_up(plugin: EditorPlugin, dock: PlaygroundDock) -> void:
	name = "ViewportTool"
	_plugin = plugin
	_dock = dock
	add_child(_drawing)
	_drawing.add_child(LabDrawing.new(dock.panel.lab))
	pointer = ViewPointer.new(_drawing, dock.document, dock.panel.edits, dock.panel.list)
	pointer.picks_faces = false
	pointer.clears_selection = false
	pointer.can_pick = _is_outside_gizmo
	pointer.redraw_needed.connect(_plugin.update_overlays)
	_nodes = SelectedNodes.new(dock, _drawing, pointer)
	toolbar = ViewportToolbar.new(pointer)
	toolbar.visibility_toggled.connect(_update_visibility.unbind(1))
	_plugin.add_control_to_container(EditorPlugin.CONTAINER_SPATIAL_EDITOR_MENU, toolbar)
	_plugin.set_input_event_forwarding_always_enabled()
	_plugin.set_force_draw_over_forwarding_enabled()
	_update_visibility()


func _exit_tree() -> void:
	if toolbar != null:
		pointer.cancel()
		_nodes.stop()
		_plugin.remove_control_from_container(EditorPlugin.CONTAINER_SPATIAL_EDITOR_MENU, toolbar)
		toolbar.queue_free()
		toolbar = null


func _process(_delta: float) -> void:
	_update_visibility()
	_nodes.follow()
	if visible and _have_views_moved():
		_plugin.update_overlays()


## Returns a value for EditorPlugin._forward_3d_gui_input().
func forward_input(camera: Camera3D, event: InputEvent) -> int:
	var mouse := event as InputEventMouse
	if not visible or (mouse != null and mouse.alt_pressed and not pointer.is_dragging()):
		return EditorPlugin.AFTER_GUI_INPUT_PASS
	var seen := event
	if mouse != null:
		seen = event.xformed_by(Transform2D().scaled(Vector2.ONE / _stretch_of(camera)))
	if pointer.handle_input(seen, camera) or (mouse != null and _nodes.handle_click(seen, camera)):
		return EditorPlugin.AFTER_GUI_INPUT_STOP
	return EditorPlugin.AFTER_GUI_INPUT_PASS


func draw_over(overlay: Control) -> void:
	var camera := _camera_below(overlay)
	if not overlay.mouse_exited.is_connected(pointer.clear_mouse):
		overlay.mouse_exited.connect(pointer.clear_mouse)
	if visible and camera != null:
		var stretch := _stretch_of(camera)
		overlay.draw_set_transform(Vector2.ZERO, 0.0, Vector2.ONE * stretch)
		HandleOverlay.draw(overlay, camera, pointer)
		overlay.draw_set_transform(Vector2.ZERO)


## Saves the dock's own document, not that of a selected node.
func save_document() -> void:
	_nodes.with_own_document(_dock.save_all)


func _update_visibility() -> void:
	var is_open := _is_dock_open()
	toolbar.visible = is_open
	var was_visible := visible
	visible = is_open and toolbar.is_showing()
	if visible != was_visible:
		if not visible:
			pointer.cancel()
			pointer.adding = &""
		_plugin.update_overlays()


# A closed dock is neither in a dock slot nor in its own window.
func _is_dock_open() -> bool:
	return (
		_dock.is_inside_tree()
		and (
			_dock.get_parent() is TabContainer
			or _dock.get_window() != EditorInterface.get_base_control().get_window()
		)
	)


func _is_outside_gizmo(camera: Camera3D, point: Vector2) -> bool:
	var reach: float = EditorInterface.get_editor_settings().get_setting(MANIPULATOR_SIZE)
	for node in EditorInterface.get_selection().get_transformable_selected_nodes():
		var selected := node as Node3D
		if selected != null and not camera.is_position_behind(selected.global_position):
			if (
				camera.unproject_position(selected.global_position).distance_to(point)
				< reach * EditorInterface.get_editor_scale() * 1.2
			):
				return false
	return true


func _have_views_moved() -> bool:
	var has_moved := false
	for index in VIEWPORTS:
		var camera := EditorInterface.get_editor_viewport_3d(index).get_camera_3d()
		if (
			camera != null
			and camera.is_visible_in_tree()
			and _views.get(camera) != camera.global_transform
		):
			_views[camera] = camera.global_transform
			has_moved = true
	return has_moved


func _camera_below(overlay: Control) -> Camera3D:
	for index in VIEWPORTS:
		var viewport := EditorInterface.get_editor_viewport_3d(index)
		if overlay.get_parent().is_ancestor_of(viewport):
			return viewport.get_camera_3d()
	return null


# A viewport may be rendered at a lower resolution than its size on the screen.
func _stretch_of(camera: Camera3D) -> float:
	var container := camera.get_viewport().get_parent() as SubViewportContainer
	return float(container.stretch_shrink) if container != null and container.stretch else 1.0
