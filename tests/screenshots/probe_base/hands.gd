@tool
extends RefCounted
## Mouse and keyboard: events as the window would get them.


## Presses and releases the middle of a control.
static func click(control: Control, button := MOUSE_BUTTON_LEFT, with_control := false, at := Vector2(0.5, 0.5)) -> void:
	var place := control.get_global_transform_with_canvas() * (control.size * at)
	var motion := InputEventMouseMotion.new()
	motion.position = place
	motion.global_position = place
	control.get_viewport().push_input(motion)
	for pressed: bool in [true, false]:
		var event := InputEventMouseButton.new()
		event.button_index = button
		event.pressed = pressed
		event.position = place
		event.global_position = place
		event.ctrl_pressed = with_control
		control.get_viewport().push_input(event)


## Drags from the middle of a control, in steps.
static func drag(control: Control, from: Vector2, to: Vector2, steps := 8) -> void:
	var transform := control.get_global_transform_with_canvas()
	for step in steps + 3:
		var place := transform * (from.lerp(to, clampf((step - 1.0) / steps, 0.0, 1.0)) * control.size)
		var event: InputEventMouse
		if step in [1, steps + 2]:
			var press := InputEventMouseButton.new()
			press.button_index = MOUSE_BUTTON_LEFT
			press.pressed = step == 1
			event = press
		else:
			var motion := InputEventMouseMotion.new()
			motion.button_mask = MOUSE_BUTTON_MASK_LEFT if step > 1 else 0 as MouseButtonMask
			motion.relative = transform.basis_xform((to - from) * control.size) / steps
			event = motion
		event.position = place
		event.global_position = place
		control.get_viewport().push_input(event)


static func press_key(window: Viewport, key: Key, unicode := 0, with_control := false, with_shift := false, with_alt := false) -> void:
	for pressed: bool in [true, false]:
		var event := InputEventKey.new()
		event.keycode = key
		event.physical_keycode = key
		event.unicode = unicode if pressed else 0
		event.pressed = pressed
		event.ctrl_pressed = with_control
		event.shift_pressed = with_shift
		event.alt_pressed = with_alt
		window.push_input(event)


static func type(window: Viewport, text: String) -> void:
	for letter in text:
		press_key(window, KEY_NONE, letter.unicode_at(0))


## Clicks into a text, and writes another in its place.
static func write_over(edit: LineEdit, text: String) -> void:
	click(edit)
	press_key(edit.get_viewport(), KEY_A, 0, true)
	type(edit.get_viewport(), text)


## Presses a field that captures the mouse, and moves so many pixels to the right.
static func drag_with(control: Control, pixels: int, steps := 8) -> void:
	var place := control.get_global_transform_with_canvas() * (control.size * 0.5)
	for step in steps + 2:
		var event: InputEventMouse
		if step in [0, steps + 1]:
			var press := InputEventMouseButton.new()
			press.button_index = MOUSE_BUTTON_LEFT
			press.pressed = step == 0
			event = press
		else:
			var motion := InputEventMouseMotion.new()
			motion.relative = Vector2(float(pixels) / steps, 0)
			motion.button_mask = MOUSE_BUTTON_MASK_LEFT
			event = motion
		event.position = place
		event.global_position = place
		control.get_viewport().push_input(event)
