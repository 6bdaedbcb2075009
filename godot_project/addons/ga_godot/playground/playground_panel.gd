@tool
extends "panel/sharing_column.gd"
## The playground without its view: menus, buttons, entries, expression line, coefficients and
## interpolation. The editor's dock and a running game use the same panel with different hosts.

const PlaygroundDocument := preload("document/playground_document.gd")
const PlaygroundHost := preload("playground_host.gd")
const EntryEdits := preload("document/entry_edits.gd")
const EntryList := preload("entries/entry_list.gd")
const EntryMenu := preload("entries/entry_menu.gd")
const FoldPanel := preload("panel/fold_panel.gd")
const FileMenu := preload("panel/file_menu.gd")
const ObjectButtons := preload("panel/object_buttons.gd")
const CombinationButtons := preload("panel/combination_buttons.gd")
const ExpressionLine := preload("panel/expression_line.gd")
const CoefficientsPanel := preload("panel/coefficients_panel.gd")
const DescriptionPanel := preload("panel/description_panel.gd")
const ExamplesMenu := preload("panel/examples_menu.gd")
const PictureDialog := preload("picture/picture_dialog.gd")
const InterpolationLab := preload("lab/interpolation_lab.gd")
const LabDrawing := preload("lab/lab_drawing.gd")
const LabPanel := preload("lab/lab_panel.gd")

var host: PlaygroundHost
var document: PlaygroundDocument
var edits: EntryEdits
var list: EntryList
var file_menu: FileMenu
## The model of the interpolation panel and of lab/lab_drawing.gd.
var lab: InterpolationLab
## Menus and buttons for the whole scene. add_to_toolbar() adds more.
var toolbar := HBoxContainer.new()
## The description of the scene, above the buttons.
var top := VBoxContainer.new()
## Foldable panels for the selected entries, at the bottom.
var bottom := VBoxContainer.new()

var _top_scroll := CappedScroll.new(top)
var _bottom_scroll := CappedScroll.new(bottom)
var _file_name := Label.new()
var _examples := ExamplesMenu.new()
var _examples_button := Button.new()
var _description := DescriptionPanel.new()
var _picture_dialog: PictureDialog


func _init(p_host: PlaygroundHost) -> void:
	name = "Panel"
	host = p_host
	document = PlaygroundDocument.new(host.history)
	edits = EntryEdits.new(document)
	list = EntryList.new(document, edits)
	file_menu = FileMenu.new(document, edits, host)
	var objects := ObjectButtons.new(edits)
	var combinations := CombinationButtons.new(edits, list)
	var line := ExpressionLine.new(document, edits)
	_make_toolbar()
	top.name = "Top"
	bottom.name = "Bottom"
	bottom.add_child(CoefficientsPanel.new(document, list, host))
	lab = InterpolationLab.new(document)
	var lab_panel := LabPanel.new(lab, list, host)
	bottom.add_child(lab_panel)
	for part: Control in [
		toolbar, _top_scroll, objects, combinations, HSeparator.new(), list, line, _bottom_scroll
	]:
		add_child(part)
	top.add_child(_description)
	_top_scroll.name = "Upper"
	_bottom_scroll.name = "Lower"
	for part: FoldPanel in bottom.get_children():
		part.folding_changed.connect(_on_folding_changed.bind(part))
	_picture_dialog = PictureDialog.new(host.make_file_dialog())
	add_child(_picture_dialog)
	add_child(EntryMenu.new(document, edits, list, host))
	objects.added.connect(select)
	combinations.added.connect(select)
	line.added.connect(select)
	lab_panel.added.connect(select)
	document.changed.connect(_show_file_name)
	document.scene_switched.connect(_on_scene_switched)
	file_menu.picture_requested.connect(_on_picture_requested)
	list.show_entries()
	_on_scene_switched()


func show_scene(scene: GAScene) -> void:
	if scene != document.scene:
		document.show_scene(scene, scene.resource_path)


func select(entry: String) -> void:
	list.select([entry])
	list.scroll_to.call_deferred(entry)


## Adds a menu or button before the file name.
func add_to_toolbar(control: Control) -> void:
	toolbar.add_child(control)
	toolbar.move_child(control, _file_name.get_index())


func _make_toolbar() -> void:
	toolbar.name = "Toolbar"
	toolbar.add_child(file_menu)
	_examples_button.name = "ExamplesButton"
	_examples_button.text = "Examples"
	_examples_button.theme_type_variation = &"FlatButton"
	_examples_button.focus_mode = Control.FOCUS_NONE
	_examples_button.tooltip_text = "Open an example construction."
	_examples_button.pressed.connect(_open_examples)
	_examples.chosen.connect(_on_example_chosen)
	_examples.failed.connect(host.warn)
	_examples_button.add_child(_examples)
	toolbar.add_child(_examples_button)
	_file_name.name = "FileName"
	_file_name.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_file_name.text_overrun_behavior = TextServer.OVERRUN_TRIM_ELLIPSIS
	_file_name.horizontal_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	_file_name.modulate = Color(1, 1, 1, 0.65)
	_file_name.mouse_filter = Control.MOUSE_FILTER_PASS
	toolbar.add_child(_file_name)


func _open_examples() -> void:
	_examples.reset_size()
	_examples.position = (
		_examples_button.get_screen_position() + Vector2(0.0, _examples_button.size.y)
	)
	_examples.popup()


func _on_example_chosen(scene: GAScene, _title: String) -> void:
	file_menu.confirm_discard(func() -> void: document.show_scene(scene, ""))


func _on_picture_requested() -> void:
	var view := host.make_view_point()
	if view == null:
		host.warn("There is no 3D view to export. Open a 3D view first.")
	else:
		_picture_dialog.ask(document.scene, view, host.get_view_size(), _draw_lab)


func _on_folding_changed(is_folded: bool, part: FoldPanel) -> void:
	if not is_folded and is_visible_in_tree():
		_bottom_scroll.ensure_control_visible.call_deferred(part)


func _draw_lab() -> Array[Node3D]:
	return [LabDrawing.new(lab)]


func _on_scene_switched() -> void:
	_description.scene = document.scene
	_show_file_name()


func _show_file_name() -> void:
	_file_name.text = (
		("[unsaved]" if document.path.is_empty() else document.get_file().get_file())
		+ ("*" if document.is_unsaved() else "")
	)
	_file_name.tooltip_text = (
		"Embedded in %s and saved with it." % document.get_file()
		if document.is_embedded()
		else document.path
	)
