@tool
@abstract
extends "step_probe.gd"
## Mouse input in the editor's first 3D viewport, with positions in its pixels, and access to the
## editor.


## Drags a handle and checks that it reaches the mouse, that the dependents follow during the drag,
## and that one undo restores the document.
func _check_drag(
	entry: String, key: String, by: Vector2, dependents: Array[String], reaches := true
) -> void:
	var scene := _scene()
	var before := scene.document
	var values := _values(dependents)
	var place := _handle_place(entry, key)
	var followed := {}
	_move_mouse(place, 0)
	_press(place, true)
	for step in 6:
		_move_mouse(place + by * (step + 1) / 6.0, MOUSE_BUTTON_MASK_LEFT)
		if step == 3:
			for dependent in dependents:
				followed[dependent] = _values([dependent])[0] != values[dependents.find(dependent)]
	_press(place + by, false)
	for dependent in dependents:
		_expect(followed[dependent], true, "%s follows %s of %s" % [dependent, key, entry])
	if reaches:
		var distance := _handle_place(entry, key).distance_to(place + by)
		_expect(
			distance < 2.5,
			true,
			(
				"%s of %s is %f pixels from the mouse: %s"
				% [key, entry, distance, scene.get_expression(entry)]
			)
		)
	_expect(scene.document != before, true, "%s of %s being changed by the drag" % [key, entry])
	_undo()
	_expect(scene.document, before, "document after undoing the drag of %s of %s" % [key, entry])


func _drag(from: Vector2, to: Vector2, with_control := false) -> void:
	_move_mouse(from, 0)
	_press(from, true)
	for step in 4:
		_move_mouse(from.lerp(to, (step + 1) / 4.0), MOUSE_BUTTON_MASK_LEFT, with_control)
	_press(to, false)


func _click_at(place: Vector3) -> void:
	var point := _camera().unproject_position(place)
	_move_mouse(point, 0)
	_press(point, true)
	_press(point, false)


func _press(place: Vector2, pressed: bool) -> void:
	var event := InputEventMouseButton.new()
	event.button_index = MOUSE_BUTTON_LEFT
	event.pressed = pressed
	event.button_mask = MOUSE_BUTTON_MASK_LEFT if pressed else 0 as MouseButtonMask
	_send(event, place)


func _move_mouse(place: Vector2, buttons: int, with_control := false) -> void:
	var event := InputEventMouseMotion.new()
	event.button_mask = buttons as MouseButtonMask
	event.ctrl_pressed = with_control
	_send(event, place)


func _send(event: InputEventMouse, place: Vector2) -> void:
	event.position = _surface().get_global_transform_with_canvas() * place
	event.global_position = event.position
	_surface().get_viewport().push_input(event)


func _handle_place(entry: String, key: String) -> Vector2:
	for handle: RefCounted in _pointer().call(&"get_handles", _camera()):
		if (
			(handle.get(&"node") as GANode3D).entry == StringName(entry)
			and (handle.get(&"handle") as Dictionary)["key"] == key
		):
			return handle.get(&"position")
	_expect("none", key, "handle of %s" % entry)
	return Vector2.ZERO


func _undo() -> void:
	(
		get_undo_redo()
		. get_history_undo_redo(
			(
				EditorUndoRedoManager.GLOBAL_HISTORY
				if not _scene().resource_path.contains("::")
				else get_undo_redo().get_object_history_id(_edited())
			)
		)
		. undo()
	)


func _select(entries: PackedStringArray) -> void:
	var list: Control = _dock().find_child("Entries", true, false)
	list.call(&"select", entries)


func _selection() -> PackedStringArray:
	return _dock().find_child("Entries", true, false).get(&"selection")


func _selected_nodes() -> Array:
	return EditorInterface.get_selection().get_selected_nodes()


func _edited() -> Node:
	return EditorInterface.get_edited_scene_root()


func _surface() -> Control:
	return EditorInterface.get_editor_viewport_3d(0).get_parent()


func _camera() -> Camera3D:
	return EditorInterface.get_editor_viewport_3d(0).get_camera_3d()


func _tool() -> Node3D:
	return get_tree().root.find_child("ViewportTool", true, false)


func _pointer() -> RefCounted:
	return _tool().get(&"pointer")


func _tools() -> Control:
	return get_tree().root.find_child("GAPlaygroundTools", true, false)


func _dock() -> EditorDock:
	return get_tree().root.find_children("GAPlayground", "EditorDock", true, false)[0]


func _scene() -> GAScene:
	return (_dock().get(&"document") as RefCounted).get(&"scene")


func _values(entries: Array[String]) -> Array:
	return entries.map(
		func(entry: String) -> PackedFloat64Array: return _scene().get_value(entry).coefficients
	)
