@tool
extends RefCounted
## Simulates mouse and keyboard: pushes input events to a viewport, in its own coordinates.


static func click(
	control: Control, button := MOUSE_BUTTON_LEFT, with_control := false, at := Vector2(0.5, 0.5)
) -> void:
	var place := place_in(control, at)
	move(control.get_viewport(), place, 0)
	press(control.get_viewport(), place, true, button, with_control)
	press(control.get_viewport(), place, false, button, with_control)


## Drags in steps between positions in two controls, relative to their sizes (0 to 1).
static func drag(
	from: Control,
	start: Vector2,
	to: Control,
	end: Vector2,
	button := MOUSE_BUTTON_LEFT,
	steps := 8
) -> void:
	var viewport := from.get_viewport()
	var first := place_in(from, start)
	var last := place_in(to, end)
	move(viewport, first, 0)
	press(viewport, first, true, button)
	for step in steps:
		move(
			viewport,
			first.lerp(last, (step + 1.0) / steps),
			1 << (button - 1),
			(last - first) / steps
		)
	press(viewport, last, false, button)


## Drags a control that captures the mouse to the right by [param pixels].
static func drag_with(control: Control, pixels: int, steps := 8) -> void:
	var place := place_in(control, Vector2(0.5, 0.5))
	press(control.get_viewport(), place, true)
	for step in steps:
		move(
			control.get_viewport(), place, MOUSE_BUTTON_MASK_LEFT, Vector2(float(pixels) / steps, 0)
		)
	press(control.get_viewport(), place, false)


static func place_in(control: Control, at: Vector2) -> Vector2:
	return control.get_global_transform_with_canvas() * (control.size * at)


static func move(viewport: Viewport, place: Vector2, buttons: int, by := Vector2.ZERO) -> void:
	var motion := InputEventMouseMotion.new()
	motion.position = place
	motion.global_position = place
	motion.relative = by
	motion.button_mask = buttons as MouseButtonMask
	viewport.push_input(motion, true)


static func press(
	viewport: Viewport,
	place: Vector2,
	pressed: bool,
	button := MOUSE_BUTTON_LEFT,
	with_control := false
) -> void:
	var event := InputEventMouseButton.new()
	event.button_index = button
	event.button_mask = (1 << (button - 1) if pressed else 0) as MouseButtonMask
	event.pressed = pressed
	event.position = place
	event.global_position = place
	event.ctrl_pressed = with_control
	viewport.push_input(event, true)


static func press_key(viewport: Viewport, key: Key, modifiers := 0, unicode := 0) -> void:
	for pressed: bool in [true, false]:
		var event := InputEventKey.new()
		event.keycode = key
		event.physical_keycode = key
		event.unicode = unicode if pressed else 0
		event.pressed = pressed
		event.ctrl_pressed = modifiers & KEY_MASK_CTRL != 0
		event.shift_pressed = modifiers & KEY_MASK_SHIFT != 0
		event.alt_pressed = modifiers & KEY_MASK_ALT != 0
		viewport.push_input(event, true)


static func type(viewport: Viewport, text: String) -> void:
	for letter in text:
		press_key(viewport, KEY_NONE, 0, letter.unicode_at(0))


## Replaces the text of a line edit.
static func write_over(edit: LineEdit, text: String) -> void:
	click(edit)
	press_key(edit.get_viewport(), KEY_A, KEY_MASK_CTRL)
	type(edit.get_viewport(), text)
