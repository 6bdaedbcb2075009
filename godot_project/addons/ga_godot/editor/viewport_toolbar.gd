@tool
extends HBoxContainer
## Two buttons in the toolbar of the 3D viewports: one toggles the visibility of the playground's
## objects, the other selects the kind of object that a click adds.

signal visibility_toggled(on: bool)

const NewObjects := preload("../playground/document/new_objects.gd")
const PlaygroundIcons := preload("../playground/theme/playground_icons.gd")
const ViewPointer := preload("../playground/view/view_pointer.gd")

const SHOWN_TEXT := (
	"Toggle the visibility of the GA Playground's objects.\n"
	+ "Drag an object, or a handle of a selected one.\n"
	+ "Ctrl: Snap. Shift: Keep the height. Esc: Cancel."
)
const ADDING_TEXT := "Add objects to the GA Playground by clicking in the viewport."

var _pointer: ViewPointer
var _shown := Button.new()
var _adding := MenuButton.new()


func _init(pointer: ViewPointer) -> void:
	name = "GAPlaygroundTools"
	_pointer = pointer
	add_child(VSeparator.new())
	_shown.name = "Shown"
	_shown.toggle_mode = true
	_shown.button_pressed = true
	_shown.tooltip_text = SHOWN_TEXT
	_shown.toggled.connect(_on_shown_toggled)
	_adding.name = "Adding"
	_adding.flat = false
	_adding.toggle_mode = true
	_adding.tooltip_text = ADDING_TEXT
	for button: Button in [_shown, _adding]:
		button.theme_type_variation = &"FlatButton"
		button.focus_mode = Control.FOCUS_NONE
		add_child(button)
	_adding.get_popup().id_pressed.connect(_on_kind_chosen)
	pointer.adding_changed.connect(_show_adding)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree():
		_shown.icon = PlaygroundIcons.make(&"intersect", self)
		_fill_menu()
		_show_adding()


func is_showing() -> bool:
	return _shown.button_pressed


func _fill_menu() -> void:
	var menu := _adding.get_popup()
	menu.clear()
	for kind in _kinds():
		menu.add_icon_item(
			PlaygroundIcons.make(kind, self), NewObjects.TITLES[kind], NewObjects.KINDS.find(kind)
		)
	menu.add_separator()
	menu.add_item("Stop Adding (Esc)")
	menu.set_item_id(menu.item_count - 1, NewObjects.KINDS.size())


# Numbers have no position.
func _kinds() -> Array[StringName]:
	return NewObjects.KINDS.filter(func(kind: StringName) -> bool: return kind != &"scalar")


func _on_kind_chosen(id: int) -> void:
	_pointer.adding = NewObjects.KINDS[id] if id < NewObjects.KINDS.size() else &""
	_show_adding()


func _on_shown_toggled(on: bool) -> void:
	_adding.disabled = not on
	visibility_toggled.emit(on)


func _show_adding() -> void:
	var is_adding := not _pointer.adding.is_empty()
	_adding.icon = (
		PlaygroundIcons.make(_pointer.adding, self)
		if is_adding
		else get_theme_icon(&"Add", &"EditorIcons")
	)
	_adding.set_pressed_no_signal(is_adding)
	_adding.tooltip_text = (
		(
			"Click in the viewport to add a %s. Press Esc to stop."
			% NewObjects.TITLES[_pointer.adding].to_lower()
		)
		if is_adding
		else ADDING_TEXT
	)
	_adding.get_popup().set_item_disabled(_adding.get_popup().item_count - 1, not is_adding)
