@tool
extends EditorDock
## "GA Playground": named expressions of geometric algebra, made by buttons and by typing.

const PlaygroundDocument := preload("playground_document.gd")
const EntryEdits := preload("entry_edits.gd")
const EntryList := preload("entry_list.gd")
const EntryMenu := preload("entry_menu.gd")
const FileMenu := preload("file_menu.gd")
const ObjectButtons := preload("object_buttons.gd")
const CombinationButtons := preload("combination_buttons.gd")
const ExpressionLine := preload("expression_line.gd")
const CoefficientsPanel := preload("coefficients_panel.gd")
const NodeCreation := preload("node_creation.gd")
const PlaygroundIcons := preload("playground_icons.gd")
const Session := preload("session.gd")

const WIDTH := 220.0

var document: PlaygroundDocument

var _file_menu: FileMenu
var _file_name := Label.new()
var _list: EntryList


## Before the dock is added.
func set_up(undo_redo: EditorUndoRedoManager) -> void:
	name = "GAPlayground"
	title = "GA Playground"
	layout_key = "ga_playground"
	default_slot = DOCK_SLOT_RIGHT_UL
	available_layouts = DOCK_LAYOUT_VERTICAL | DOCK_LAYOUT_FLOATING
	closable = true
	custom_minimum_size.x = WIDTH * EditorInterface.get_editor_scale()
	document = PlaygroundDocument.new(undo_redo)
	var edits := EntryEdits.new(document)
	_list = EntryList.new(document, edits)
	_file_menu = FileMenu.new(document, edits)
	var objects := ObjectButtons.new(edits)
	var combinations := CombinationButtons.new(edits, _list)
	var line := ExpressionLine.new(document, edits)
	var column := VBoxContainer.new()
	column.name = "Column"
	add_child(column)
	for part: Control in [_make_head(), objects, combinations, HSeparator.new(), _list, line, CoefficientsPanel.new(document, _list)]:
		column.add_child(part)
	add_child(EntryMenu.new(document, edits, _list, NodeCreation.new(document, undo_redo)))
	objects.added.connect(_select)
	combinations.added.connect(_select)
	line.added.connect(_select)
	document.changed.connect(_show_file_name)
	document.scene_switched.connect(_show_file_name)
	Session.restore(document)
	_list.show_entries()
	_show_file_name()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree():
		dock_icon = PlaygroundIcons.make(&"intersect", self)


func show_scene(scene: GAScene) -> void:
	if scene != document.scene:
		document.show_scene(scene, scene.resource_path)


## What has a file is saved there; all else is kept for the next start.
func keep() -> void:
	if document.path.get_extension() in ["tres", "json"] and document.is_unsaved():
		_file_menu.save(document.path)
	Session.keep(document)


func keep_session() -> void:
	Session.keep(document)


func _make_head() -> Control:
	var head := HBoxContainer.new()
	head.add_child(_file_menu)
	_file_name.name = "FileName"
	_file_name.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_file_name.text_overrun_behavior = TextServer.OVERRUN_TRIM_ELLIPSIS
	_file_name.horizontal_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	_file_name.modulate = Color(1, 1, 1, 0.65)
	_file_name.mouse_filter = Control.MOUSE_FILTER_PASS
	head.add_child(_file_name)
	return head


func _select(entry: String) -> void:
	_list.select([entry])
	_list.scroll_to.call_deferred(entry)


func _show_file_name() -> void:
	_file_name.text = ("not saved yet" if document.path.is_empty() else document.path.get_file()) + ("*" if document.is_unsaved() else "")
	_file_name.tooltip_text = document.path
