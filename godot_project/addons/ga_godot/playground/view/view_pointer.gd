@tool
extends RefCounted
## Handles the mouse over a view of a document: hovers, selects, drags handles and objects, adds
## objects. Works for the editor's viewports and for a game's view; pass it every event of the view.

## Emitted when the overlay of the view needs to be redrawn.
signal redraw_needed
## Emitted when `adding` changes.
signal adding_changed

const PlaygroundDocument := preload("../document/playground_document.gd")
const EntryEdits := preload("../document/entry_edits.gd")
const EntryList := preload("../entries/entry_list.gd")
const ClickAdding := preload("click_adding.gd")
const HandleDrag := preload("handle_drag.gd")
const ObjectGrab := preload("object_grab.gd")
const Picking := preload("picking.gd")
const SceneDrawing := preload("scene_drawing.gd")
const ViewHandle := preload("view_handle.gd")

## A press becomes a drag at this distance, in pixels.
const DRAG_THRESHOLD := 4.0

## The kind (of NewObjects.KINDS) that a click adds; empty for none.
var adding := &"":
	set = set_adding
## The kind that a double click on empty space adds; empty for none.
var double_click_adds := &""
## Whether planes and spheres are picked anywhere on their surface, not only at their lines.
var picks_faces := true
## Whether objects can be picked at a point of the screen; called with the camera and the point.
var can_pick := func(_camera: Camera3D, _point: Vector2) -> bool: return true
## Whether a click on empty space clears the selection.
var clears_selection := true
## Other nodes that draw entries of the document and have handles.
var other_nodes: Array[GANode3D] = []

var document: PlaygroundDocument
var drawing: SceneDrawing
var hovered_handle: ViewHandle
var hovered_node: GANode3D
## The last position of the mouse, and the camera of that view.
var mouse := Vector2.INF
var mouse_camera: Camera3D

var _edits: EntryEdits
var _list: EntryList
var _drag: HandleDrag
# The handle that is pressed but not yet dragged.
var _pressed: ViewHandle
# The entry that is selected if the press ends as a click.
var _pressed_selects := ""
var _pressed_adds := false
var _pressed_at := Vector2.INF
var _pressed_empty_space := false


func _init(
	p_drawing: SceneDrawing, p_document: PlaygroundDocument, edits: EntryEdits, list: EntryList
) -> void:
	drawing = p_drawing
	document = p_document
	_edits = edits
	_list = list
	document.scene_switched.connect(_on_scene_switched)
	document.changed.connect(redraw_needed.emit)
	list.selection_changed.connect(_on_selection_changed)
	_on_scene_switched()


func set_adding(kind: StringName) -> void:
	if adding != kind:
		adding = kind
		adding_changed.emit()
		_hover(null, null)
		redraw_needed.emit()


func is_dragging() -> bool:
	return _drag != null


func get_drag() -> HandleDrag:
	return _drag


func get_selection() -> PackedStringArray:
	return _list.selection


## The handles of the selected entries.
func get_handles(camera: Camera3D) -> Array[RefCounted]:
	var found: Array[RefCounted] = []
	for node in get_nodes():
		if _list.selection.has(String(node.entry)):
			found.append_array(ViewHandle.of(node, camera))
	return found


## All nodes that draw entries of the document.
func get_nodes() -> Array[GANode3D]:
	var nodes: Array[GANode3D] = []
	if drawing.is_visible_in_tree():
		nodes = drawing.get_nodes()
	for node in other_nodes:
		if is_instance_valid(node) and node.is_inside_tree() and node.scene == document.scene:
			nodes.append(node)
	return nodes


## Returns whether the event was used and should not be handled further.
func handle_input(event: InputEvent, camera: Camera3D) -> bool:
	var key := event as InputEventKey
	if key != null:
		return key.pressed and key.keycode == KEY_ESCAPE and _escape()
	var motion := event as InputEventMouseMotion
	if motion != null:
		return _move(motion, camera)
	var button := event as InputEventMouseButton
	if button == null:
		return false
	if button.button_index == MOUSE_BUTTON_RIGHT and button.pressed and _drag != null:
		return cancel()
	if button.button_index != MOUSE_BUTTON_LEFT:
		return false
	return _press(button, camera) if button.pressed else _release(button)


## Cancels the current drag and restores the document. Returns whether there was one.
func cancel() -> bool:
	var drag := _drag
	_clear_press()
	if drag != null:
		drag.cancel()
	return drag != null


## Call this when the mouse leaves the view.
func clear_mouse() -> void:
	mouse = Vector2.INF
	_hover(null, null)
	redraw_needed.emit()


func _escape() -> bool:
	if cancel():
		return true
	var was_adding := not adding.is_empty()
	adding = &""
	return was_adding


func _move(motion: InputEventMouseMotion, camera: Camera3D) -> bool:
	mouse = motion.position
	mouse_camera = camera
	if _drag == null and _pressed != null and mouse.distance_to(_pressed_at) >= DRAG_THRESHOLD:
		_drag = HandleDrag.new(document, _pressed, _pressed_at)
	if _drag != null:
		if not motion.button_mask & MOUSE_BUTTON_MASK_LEFT:
			# The button was released outside the view.
			_end_drag()
			return false
		_drag.move(camera, mouse, motion.is_command_or_control_pressed(), motion.shift_pressed)
		redraw_needed.emit()
		return true
	if _pressed_at.is_finite() and not _pressed_empty_space:
		return true
	if motion.button_mask == 0:
		_hover_at(camera, mouse)
	return false


func _press(button: InputEventMouseButton, camera: Camera3D) -> bool:
	if _drag != null:
		_end_drag()
	_clear_press()
	_pressed_at = button.position
	var snaps := button.is_command_or_control_pressed()
	if not adding.is_empty():
		_select([ClickAdding.add(_edits, drawing, adding, camera, button.position, snaps)])
		return true
	_hover_at(camera, button.position)
	if hovered_handle != null:
		_pressed = hovered_handle
		_pressed_selects = String(hovered_handle.node.entry)
		_pressed_adds = snaps or button.shift_pressed
		return true
	if hovered_node != null:
		_select_object(String(hovered_node.entry), snaps or button.shift_pressed)
		_pressed = ObjectGrab.take(hovered_node, camera, button.position)
		return true
	if button.double_click and not double_click_adds.is_empty():
		_select(
			[ClickAdding.add(_edits, drawing, double_click_adds, camera, button.position, snaps)]
		)
		return true
	_pressed_empty_space = true
	return false


func _release(button: InputEventMouseButton) -> bool:
	var was_used := _pressed_at.is_finite() and not _pressed_empty_space
	if _drag != null:
		_end_drag()
	elif document.scene.has_entry(_pressed_selects):
		# A click on a handle selects its object.
		_select_object(_pressed_selects, _pressed_adds)
	elif (
		_pressed_empty_space
		and clears_selection
		and button.position.distance_to(_pressed_at) < DRAG_THRESHOLD
	):
		_select([])
	_clear_press()
	return was_used


func _end_drag() -> void:
	_drag.end()
	_clear_press()
	redraw_needed.emit()


func _clear_press() -> void:
	_drag = null
	_pressed = null
	_pressed_selects = ""
	_pressed_empty_space = false
	_pressed_at = Vector2.INF


func _select_object(entry: String, adding_to_others: bool) -> void:
	var chosen := _list.selection.duplicate() if adding_to_others else PackedStringArray()
	if adding_to_others and chosen.has(entry):
		chosen.remove_at(chosen.find(entry))
	elif not chosen.has(entry):
		chosen.append(entry)
	_select(chosen)


func _select(entries: PackedStringArray) -> void:
	_list.select(entries)
	if entries.size() == 1:
		_list.scroll_to.call_deferred(entries[0])


func _hover_at(camera: Camera3D, point: Vector2) -> void:
	if not adding.is_empty():
		_hover(null, null)
		redraw_needed.emit()
		return
	var handle := Picking.find_handle(get_handles(camera), point)
	var node: GANode3D = null
	if handle == null and can_pick.call(camera, point):
		node = Picking.find_object(get_nodes(), camera, point, picks_faces)
	_hover(handle, node)


func _hover(handle: ViewHandle, node: GANode3D) -> void:
	var has_changed := (
		node != hovered_node
		or (handle == null) != (hovered_handle == null)
		or (handle != null and not handle.is_same(hovered_handle))
	)
	hovered_handle = handle
	hovered_node = node
	if has_changed:
		drawing.emphasize(String(node.entry) if node != null else "", _list.selection)
		redraw_needed.emit()


func _on_scene_switched() -> void:
	_clear_press()
	hovered_handle = null
	hovered_node = null
	drawing.scene = document.scene
	redraw_needed.emit()


func _on_selection_changed() -> void:
	drawing.emphasize(
		String(hovered_node.entry) if is_instance_valid(hovered_node) else "", _list.selection
	)
	redraw_needed.emit()
