@tool
extends PopupMenu
## The context menu of the selected entries.

enum Item { RENAME, UP, DOWN, DUAL, NODE, SLIDER, GDSCRIPT, CPP, LATEX, JSON_NUMBERS, DELETE }

const PlaygroundDocument := preload("../document/playground_document.gd")
const EntryEdits := preload("../document/entry_edits.gd")
const EntryList := preload("entry_list.gd")
const EntryRow := preload("entry_row.gd")
const SliderRangeDialog := preload("slider_range_dialog.gd")
const ValueSlider := preload("value_slider.gd")
const CodeExport := preload("../document/code_export.gd")
const PlaygroundHost := preload("../playground_host.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")

var _document: PlaygroundDocument
var _edits: EntryEdits
var _list: EntryList
var _host: PlaygroundHost
var _row: EntryRow
var _question := ConfirmationDialog.new()
var _slider_range: SliderRangeDialog


func _init(
	document: PlaygroundDocument, edits: EntryEdits, list: EntryList, host: PlaygroundHost
) -> void:
	name = "EntryMenu"
	_document = document
	_edits = edits
	_list = list
	_host = host
	_question.name = "Question"
	_question.dialog_autowrap = true
	_question.ok_button_text = "Delete"
	_question.confirmed.connect(func() -> void: _edits.remove(_list.selection))
	add_child(_question)
	_slider_range = SliderRangeDialog.new(document, edits)
	add_child(_slider_range)
	id_pressed.connect(_on_item_pressed)
	_list.menu_requested.connect(show_for)
	_list.deletion_requested.connect(delete_selected)


func show_for(row: EntryRow) -> void:
	_row = row
	_fill()
	reset_size()
	position = row.get_screen_transform() * row.get_local_mouse_position()
	popup()


## Deletes the selected entries. Asks for confirmation if other entries would lose their values.
func delete_selected() -> void:
	var dependents := _edits.dependents(_list.selection)
	if dependents.is_empty():
		_edits.remove(_list.selection)
		return
	_question.title = "Delete %s?" % ", ".join(_list.selection)
	_question.dialog_text = (
		"%s depend%s on %s and would lose %s. You can undo the deletion."
		% [
			", ".join(dependents),
			"s" if dependents.size() == 1 else "",
			", ".join(_list.selection),
			"its value" if dependents.size() == 1 else "their values"
		]
	)
	_question.popup_centered(Vector2i(Vector2(320, 90) * PlaygroundStyle.scale()))


func _fill() -> void:
	clear()
	var index := _document.scene.get_index(_row.entry)
	add_item("Rename", Item.RENAME, KEY_F2)
	add_item("Move Up", Item.UP, KEY_MASK_ALT | KEY_UP)
	set_item_disabled(-1, index == 0)
	add_item("Move Down", Item.DOWN, KEY_MASK_ALT | KEY_DOWN)
	set_item_disabled(-1, index == _document.scene.get_entry_count() - 1)
	add_check_item("Interpret as Dual (IPNS)", Item.DUAL)
	set_item_checked(-1, _is_dual())
	if _document.scene.get_parameters(_row.entry).has(ValueSlider.PARAMETER):
		add_item("Slider Range...", Item.SLIDER)
	if _host.can_create_nodes():
		add_separator()
		add_item("Create Node", Item.NODE)
	add_separator()
	add_item("Copy as GDScript", Item.GDSCRIPT)
	add_item("Copy as C++", Item.CPP)
	add_item("Copy as LaTeX", Item.LATEX)
	add_item("Copy as 32 Numbers", Item.JSON_NUMBERS)
	add_separator()
	add_item("Delete", Item.DELETE, KEY_DELETE)


func _on_item_pressed(item: int) -> void:
	var entry := _row.entry
	match item:
		Item.RENAME:
			_row.start_renaming()
		Item.UP:
			_edits.move(entry, _document.scene.get_index(entry) - 1)
		Item.DOWN:
			_edits.move(entry, _document.scene.get_index(entry) + 1)
		Item.DUAL:
			_edits.set_attribute(entry, "ipns", not _is_dual())
		Item.SLIDER:
			_slider_range.ask(entry)
		Item.NODE:
			for selected in _list.selection:
				_host.create_node(_document.scene, selected)
		Item.GDSCRIPT:
			DisplayServer.clipboard_set(CodeExport.gdscript(_document.scene, _list.selection))
		Item.CPP:
			DisplayServer.clipboard_set(CodeExport.cpp(_document.scene, _list.selection))
		Item.LATEX:
			DisplayServer.clipboard_set(CodeExport.latex(_document.scene, _list.selection))
		Item.JSON_NUMBERS:
			var value := _document.scene.get_value(entry)
			DisplayServer.clipboard_set(value.to_json() if value != null else "")
		Item.DELETE:
			delete_selected()


func _is_dual() -> bool:
	return _document.scene.get_entry_attribute(_row.entry, "ipns")
