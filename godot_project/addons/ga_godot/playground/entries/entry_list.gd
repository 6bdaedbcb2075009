@tool
extends ScrollContainer
## The list of entries, and the selected ones in the order of selection.

signal selection_changed
signal menu_requested(row: Control)
signal deletion_requested

const PlaygroundDocument := preload("../document/playground_document.gd")
const EntryEdits := preload("../document/entry_edits.gd")
const EntryRow := preload("entry_row.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")

## The height of about two rows.
const MIN_HEIGHT := 104.0
## The key of the entry's name in drag data.
const DRAGGED := "ga_playground_entry"
const HINT := (
	"No entries yet.\n\n"
	+ "Add an object with the buttons above, open an example, or type an expression below, "
	+ "such as point(1, 2, 3)."
)

var selection := PackedStringArray()

var _document: PlaygroundDocument
var _edits: EntryEdits
var _rows := VBoxContainer.new()
var _hint := Label.new()
# Entries whose value changed since their row was last updated.
var _stale: Dictionary[String, bool] = {}
var _are_all_stale := true
# The position of the mouse in the viewport, while a row is dragged.
var _mouse := Vector2.ZERO


func _init(document: PlaygroundDocument, edits: EntryEdits) -> void:
	name = "Entries"
	_document = document
	_edits = edits
	custom_minimum_size.y = MIN_HEIGHT * PlaygroundStyle.scale()
	horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	size_flags_vertical = Control.SIZE_EXPAND_FILL
	follow_focus = true
	focus_mode = Control.FOCUS_CLICK
	_rows.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_rows.add_theme_constant_override(&"separation", 0)
	add_child(_rows)
	_hint.text = HINT
	_hint.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_hint.modulate = Color(1, 1, 1, 0.65)
	_rows.add_child(_hint)
	_document.entries_changed.connect(_on_entries_changed)
	_document.scene_switched.connect(func() -> void: _are_all_stale = true)
	_document.changed.connect(show_entries)


func _ready() -> void:
	set_process_input(false)


func show_entries() -> void:
	var names := _document.scene.get_names()
	var rows := get_rows()
	for index in range(names.size(), rows.size()):
		_keep_focus(rows[index])
		rows[index].entry = ""
		_rows.remove_child(rows[index])
		rows[index].queue_free()
	for index in names.size():
		var row := rows[index] if index < rows.size() else _add_row()
		row.refresh(names[index], _is_stale(names[index]))
	_hint.visible = names.is_empty()
	var remaining := PackedStringArray(Array(selection).filter(names.has))
	if remaining != selection or Array(selection).any(_is_stale):
		select(remaining)
	else:
		_mark_selected()
	_stale.clear()
	_are_all_stale = false


func get_rows() -> Array[EntryRow]:
	var rows: Array[EntryRow] = []
	for child in _rows.get_children():
		if child is EntryRow:
			rows.append(child)
	return rows


func find_row(entry: String) -> EntryRow:
	for row in get_rows():
		if row.entry == entry:
			return row
	return null


func scroll_to(entry: String) -> void:
	var row := find_row(entry)
	if row != null and is_visible_in_tree():
		ensure_control_visible(row)


func select(entries: PackedStringArray) -> void:
	selection = entries
	_mark_selected()
	selection_changed.emit()


# If the row has the keyboard focus, moves the focus to the list before the row is removed.
func _keep_focus(row: EntryRow) -> void:
	var focused := get_viewport().gui_get_focus_owner() if is_inside_tree() else null
	if focused != null and (focused == row or row.is_ancestor_of(focused)):
		grab_focus()


func _mark_selected() -> void:
	for row in get_rows():
		row.selected = selection.has(row.entry)


func _is_stale(entry: String) -> bool:
	return _are_all_stale or _stale.has(entry)


func _on_entries_changed(names: PackedStringArray) -> void:
	for entry in names:
		_stale[entry] = true


func _add_row() -> EntryRow:
	var row := EntryRow.new(_document, _edits)
	_rows.add_child(row)
	row.pressed.connect(_on_row_pressed)
	row.menu_requested.connect(_on_menu_requested)
	row.forward_drag(_drag.bind(row), _can_drop.bind(row), _drop.bind(row))
	row.gui_input.connect(_on_row_input.bind(row))
	return row


func _notification(what: int) -> void:
	if what == NOTIFICATION_DRAG_BEGIN:
		set_process_input(true)
	elif what == NOTIFICATION_DRAG_END:
		set_process_input(false)
		_show_drop(null, EntryRow.Drop.NONE)


# The position that the engine passes to _drop() is that of the system's mouse pointer, which
# injected events do not move.
func _input(event: InputEvent) -> void:
	var mouse := event as InputEventMouse
	if mouse != null:
		_mouse = mouse.position


## Starts dragging a row to another position in the list.
func _drag(_at: Vector2, row: EntryRow) -> Variant:
	var preview := Label.new()
	preview.text = "%s = %s" % [row.entry, _document.scene.get_expression(row.entry)]
	set_drag_preview(preview)
	return {DRAGGED: row.entry}


func _can_drop(_at: Vector2, data: Variant, row: EntryRow) -> bool:
	if (
		not data is Dictionary
		or not _document.scene.has_entry((data as Dictionary).get(DRAGGED, "") as String)
	):
		return false
	_show_drop(row, EntryRow.Drop.BELOW if _is_below(row) else EntryRow.Drop.ABOVE)
	return true


func _drop(_at: Vector2, data: Variant, row: EntryRow) -> void:
	var entry: String = (data as Dictionary)[DRAGGED]
	var from := _document.scene.get_index(entry)
	var to := _document.scene.get_index(row.entry) + (1 if _is_below(row) else 0)
	_edits.move(entry, to - 1 if from < to else to)


func _is_below(row: EntryRow) -> bool:
	return (row.get_global_transform_with_canvas().affine_inverse() * _mouse).y > row.size.y / 2.0


func _show_drop(row: EntryRow, side: EntryRow.Drop) -> void:
	for other in get_rows():
		other.drop_side = side if other == row else EntryRow.Drop.NONE


func _on_row_pressed(row: EntryRow, adding: bool) -> void:
	var entries := selection.duplicate() if adding else PackedStringArray()
	if adding and entries.has(row.entry):
		entries.remove_at(entries.find(row.entry))
	else:
		entries.append(row.entry)
	select(entries)


func _on_menu_requested(row: EntryRow) -> void:
	if not selection.has(row.entry):
		select([row.entry])
	menu_requested.emit(row)


func _on_row_input(event: InputEvent, row: EntryRow) -> void:
	if press_key(event as InputEventKey):
		row.accept_event()


## Handles a key for the entry that was selected last. Returns whether the key was used.
func press_key(key: InputEventKey) -> bool:
	if key == null or not key.pressed or selection.is_empty():
		return false
	var entry := selection[-1]
	if key.keycode == KEY_DELETE:
		deletion_requested.emit()
	elif key.keycode == KEY_F2:
		scroll_to(entry)
		find_row(entry).start_renaming()
	elif key.alt_pressed and key.keycode in [KEY_UP, KEY_DOWN]:
		_edits.move(entry, _document.scene.get_index(entry) + (-1 if key.keycode == KEY_UP else 1))
	else:
		return false
	return true
