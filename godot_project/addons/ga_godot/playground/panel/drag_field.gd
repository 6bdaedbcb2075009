@tool
extends "number_field.gd"
## The number field of a running game: drag horizontally to change the number, click to type it.

const HEIGHT := 26.0
## The distance in pixels at which a press becomes a drag.
const DRAG_START := 3.0
## Change of the number per pixel.
const SPEED := 0.01
## Factor of the speed while Shift is held.
const FINE_FACTOR := 0.1
const DIGITS := 3
const LABEL_ALPHA := 0.55
const MARGIN := 6.0

var _step: float
var _number := 0.0
var _label := ""
var _is_read_only := false
var _pressed_at := Vector2.INF
var _is_dragging := false
var _dragged := 0.0
var _edit := LineEdit.new()


func _init(step: float) -> void:
	_step = step
	custom_minimum_size.y = HEIGHT
	focus_mode = Control.FOCUS_ALL
	mouse_default_cursor_shape = Control.CURSOR_HSIZE
	_edit.visible = false
	_edit.select_all_on_focus = true
	_edit.add_theme_constant_override(&"minimum_character_width", 0)
	_edit.text_submitted.connect(func(_text: String) -> void: _end_typing(true))
	_edit.focus_exited.connect(_end_typing.bind(true))
	_edit.gui_input.connect(_on_edit_input)
	add_child(_edit)
	focus_entered.connect(queue_redraw)
	focus_exited.connect(queue_redraw)
	mouse_entered.connect(queue_redraw)
	mouse_exited.connect(queue_redraw)


func get_number() -> float:
	return _number


func show_number(number: float) -> void:
	_number = number
	queue_redraw()


func show_label(text: String) -> void:
	_label = text
	queue_redraw()


func set_read_only(read_only: bool) -> void:
	_is_read_only = read_only
	mouse_default_cursor_shape = Control.CURSOR_ARROW if read_only else Control.CURSOR_HSIZE
	queue_redraw()


func is_read_only() -> bool:
	return _is_read_only


func _draw() -> void:
	draw_style_box(
		get_theme_stylebox(&"read_only" if _is_read_only else &"normal", &"LineEdit"),
		Rect2(Vector2.ZERO, size)
	)
	if has_focus() and not _edit.visible:
		draw_style_box(get_theme_stylebox(&"focus", &"LineEdit"), Rect2(Vector2.ZERO, size))
	var font := get_theme_font(&"font", &"LineEdit")
	var font_size := get_theme_font_size(&"font_size", &"LineEdit")
	var color := get_theme_color(&"font_color", &"LineEdit")
	var line := (size.y + font.get_ascent(font_size) - font.get_descent(font_size)) / 2.0
	draw_string(
		font,
		Vector2(MARGIN, line),
		_label,
		HORIZONTAL_ALIGNMENT_LEFT,
		-1,
		font_size,
		Color(color, LABEL_ALPHA)
	)
	var label_width := font.get_string_size(_label, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
	var room := size.x - label_width - 3.0 * MARGIN
	draw_string(
		font,
		Vector2(label_width + 2.0 * MARGIN, line),
		_text(),
		HORIZONTAL_ALIGNMENT_RIGHT,
		room,
		font_size,
		color
	)


# Adding 0.0 turns -0.0 into 0.0.
func _text() -> String:
	var number := snappedf(_number, _step) + 0.0
	return str(roundi(number)) if _step >= 1.0 else String.num(number, DIGITS)


func _gui_input(event: InputEvent) -> void:
	if _is_read_only:
		return
	var button := event as InputEventMouseButton
	var motion := event as InputEventMouseMotion
	if button != null and button.button_index == MOUSE_BUTTON_LEFT:
		if button.pressed:
			_pressed_at = button.position
		else:
			_release()
		accept_event()
	elif motion != null and _pressed_at.is_finite():
		_drag(motion)
		accept_event()
	elif event.is_action_pressed(&"ui_accept"):
		_start_typing()
		accept_event()
	elif _is_dragging and event.is_action_pressed(&"ui_cancel"):
		accept_event()


func _drag(motion: InputEventMouseMotion) -> void:
	if not _is_dragging and motion.position.distance_to(_pressed_at) > DRAG_START:
		_is_dragging = true
		_dragged = _number
		grabbed.emit()
	if _is_dragging:
		_dragged += motion.relative.x * SPEED * (FINE_FACTOR if motion.shift_pressed else 1.0)
		_edit_number(snappedf(_dragged, _step))


func _release() -> void:
	var was_dragging := _is_dragging
	var was_pressed := _pressed_at.is_finite()
	_is_dragging = false
	_pressed_at = Vector2.INF
	if was_dragging:
		ungrabbed.emit()
	elif was_pressed:
		_start_typing()


func _start_typing() -> void:
	_edit.text = String.num(_number)
	_edit.visible = true
	_edit.grab_focus()
	_edit.edit()
	_edit.select_all()


func _on_edit_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"ui_cancel"):
		_end_typing(false)
		_edit.accept_event()


# Any expression with a scalar value, such as 1/3, is accepted; all others are ignored.
func _end_typing(commits: bool) -> void:
	if not _edit.visible:
		return
	_edit.visible = false
	queue_redraw()
	var value: Multivector = GAScene.new().describe_expression(_edit.text)["value"]
	if not commits or value == null:
		return
	var numbers := value.coefficients
	if numbers.slice(1).count(0.0) == numbers.size() - 1:
		_edit_number(numbers[0])


func _edit_number(number: float) -> void:
	if number != _number:
		show_number(number)
		edited.emit(number)
