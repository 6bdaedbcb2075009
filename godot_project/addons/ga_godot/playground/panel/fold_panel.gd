@tool
extends VBoxContainer
## A panel that folds to its title bar: the engine's FoldableContainer from Godot 4.5, and a button
## above the contents in Godot 4.4.

## Emitted when the panel was folded or unfolded.
signal folding_changed(is_folded: bool)

const ENGINE_CLASS := &"FoldableContainer"

var title := "":
	set(value):
		title = value
		if _engine_panel != null:
			_engine_panel.set(&"title", value)
		else:
			_button.text = value
var folded := false:
	set(value):
		if value == folded:
			return
		folded = value
		if _engine_panel != null:
			_engine_panel.set(&"folded", value)
		else:
			_show_folding()
		folding_changed.emit(value)

var _engine_panel: Container
var _bar: HBoxContainer
var _button: Button
var _contents: PanelContainer


func _init(uses_engine_class := ClassDB.class_exists(ENGINE_CLASS)) -> void:
	add_theme_constant_override(&"separation", 0)
	if uses_engine_class:
		_engine_panel = ClassDB.instantiate(ENGINE_CLASS)
		_engine_panel.connect(&"folding_changed", func(value: bool) -> void: folded = value)
		_engine_panel.size_flags_vertical = Control.SIZE_EXPAND_FILL
		add_child(_engine_panel)
	else:
		_make_parts()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree() and _button != null:
		_show_folding()


func fold() -> void:
	folded = true


func expand() -> void:
	folded = false


func add_content(control: Control) -> void:
	(_engine_panel if _engine_panel != null else _contents).add_child(control)


func add_title_bar_control(control: Control) -> void:
	if _engine_panel != null:
		_engine_panel.call(&"add_title_bar_control", control)
	else:
		_bar.add_child(control)


func _make_parts() -> void:
	_bar = HBoxContainer.new()
	add_child(_bar)
	_button = Button.new()
	_button.name = "Title"
	_button.flat = true
	_button.alignment = HORIZONTAL_ALIGNMENT_LEFT
	_button.text_overrun_behavior = TextServer.OVERRUN_TRIM_ELLIPSIS
	_button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_button.pressed.connect(func() -> void: folded = not folded)
	_bar.add_child(_button)
	_contents = PanelContainer.new()
	_contents.size_flags_vertical = Control.SIZE_EXPAND_FILL
	add_child(_contents)


func _show_folding() -> void:
	_contents.visible = not folded
	_button.icon = get_theme_icon(&"arrow_collapsed" if folded else &"arrow", &"Tree")
