@tool
extends ConfirmationDialog
## Asks for the size, background and file of a picture, and exports it with PictureExport.

signal saved(path: String)

enum Size { AS_SHOWN, TWICE, HD, UHD, CUSTOM }
enum Background { AS_SHOWN, TRANSPARENT, COLOR }

const PictureExport := preload("picture_export.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")
const ViewPoint := preload("view_point.gd")

const FIXED_SIZES: Dictionary[Size, Vector2i] = {
	Size.HD: Vector2i(1920, 1080), Size.UHD: Vector2i(3840, 2160)
}
const FIELD_WIDTH := 300.0
const FIRST_NAME := "picture.png"

var _scene: GAScene
var _view: ViewPoint
var _shown_size := Vector2i(1280, 720)
var _make_extra_nodes: Callable
var _sizes := OptionButton.new()
var _width := SpinBox.new()
var _height := SpinBox.new()
var _custom_size := HBoxContainer.new()
var _backgrounds := OptionButton.new()
var _color := ColorPickerButton.new()
var _path := LineEdit.new()
var _browse := Button.new()
var _files: FileDialog
var _error := Label.new()
var _is_drawing := false


## The file dialog comes from the host and becomes a child.
func _init(files: FileDialog) -> void:
	name = "PictureDialog"
	title = "Export Picture"
	ok_button_text = "Export"
	dialog_hide_on_ok = false
	_files = files
	_files.file_mode = FileDialog.FILE_MODE_SAVE_FILE
	_files.clear_filters()
	_files.add_filter("*.png", "PNG picture")
	_files.file_selected.connect(func(path: String) -> void: _path.text = path)
	add_child(_files)
	var grid := GridContainer.new()
	grid.columns = 2
	add_child(grid)
	_add_row(grid, "Size", _sizes)
	_add_row(grid, "", _custom_size)
	_add_row(grid, "Background", _backgrounds)
	_add_row(grid, "", _color)
	_add_row(grid, "File", _make_file_row())
	_error.name = "Error"
	_error.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_error.custom_minimum_size.x = FIELD_WIDTH * PlaygroundStyle.scale()
	_error.visible = false
	grid.add_child(Control.new())
	grid.add_child(_error)
	_fill_choices()
	confirmed.connect(export_picture)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED:
		_error.add_theme_color_override(
			&"font_color",
			(
				get_theme_color(&"error_color", &"Editor")
				if has_theme_color(&"error_color", &"Editor")
				else Color(1.0, 0.45, 0.42)
			)
		)


## Opens the dialog for the current view of a document. `make_extra_nodes` returns an Array[Node3D]
## to be drawn as well.
func ask(
	scene: GAScene, view: ViewPoint, shown_size: Vector2i, make_extra_nodes := Callable()
) -> void:
	_scene = scene
	_view = view
	_shown_size = shown_size
	_make_extra_nodes = make_extra_nodes
	_sizes.set_item_text(Size.AS_SHOWN, "As Shown (%d x %d)" % [shown_size.x, shown_size.y])
	_sizes.set_item_text(Size.TWICE, "Double Size (%d x %d)" % [2 * shown_size.x, 2 * shown_size.y])
	_width.value = shown_size.x
	_height.value = shown_size.y
	_color.color = view.background
	_error.visible = false
	if _path.text.is_empty():
		_path.text = (
			("res://" if _files.access == FileDialog.ACCESS_RESOURCES else "user://") + FIRST_NAME
		)
	popup_centered()


func chosen_size() -> Vector2i:
	match _sizes.selected:
		Size.AS_SHOWN:
			return _shown_size
		Size.TWICE:
			return 2 * _shown_size
		Size.CUSTOM:
			return Vector2i(roundi(_width.value), roundi(_height.value))
	return FIXED_SIZES[_sizes.selected as Size]


func chosen_background() -> Color:
	match _backgrounds.selected:
		Background.TRANSPARENT:
			return Color.TRANSPARENT
		Background.COLOR:
			return _color.color
	return _view.background


## Draws and saves the picture. On failure, the dialog stays open and shows the error. Returns the
## error message, or an empty string. A coroutine: use await.
func export_picture() -> String:
	if _is_drawing:
		return ""
	var export := PictureExport.new()
	export.size = chosen_size()
	export.view = _view
	export.background = chosen_background()
	export.line_scale = float(export.size.y) / _shown_size.y
	var error := PictureExport.size_error(export.size)
	if error.is_empty():
		_is_drawing = true
		var extra_nodes: Array[Node3D] = []
		if _make_extra_nodes.is_valid():
			extra_nodes = _make_extra_nodes.call()
		var image := await export.draw(self, _scene, extra_nodes)
		error = PictureExport.save(image, _path.text.strip_edges())
		_is_drawing = false
	_error.text = error
	_error.visible = not error.is_empty()
	reset_size()
	if error.is_empty():
		hide()
		saved.emit(_path.text.strip_edges())
	return error


func _add_row(grid: GridContainer, text: String, control: Control) -> void:
	var label := Label.new()
	label.text = text
	grid.add_child(label)
	control.custom_minimum_size.x = FIELD_WIDTH * PlaygroundStyle.scale()
	control.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	grid.add_child(control)


func _make_file_row() -> Control:
	var row := HBoxContainer.new()
	_path.name = "Path"
	_path.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	row.add_child(_path)
	_browse.text = "..."
	_browse.tooltip_text = "Choose a file."
	_browse.pressed.connect(_files.popup_centered_ratio.bind(0.6))
	row.add_child(_browse)
	return row


func _fill_choices() -> void:
	_sizes.name = "Size"
	for text: String in ["As Shown", "Double Size", "1920 x 1080", "3840 x 2160", "Custom"]:
		_sizes.add_item(text)
	for field: SpinBox in [_width, _height]:
		field.min_value = 1
		field.max_value = PictureExport.MAX_SIZE
		field.size_flags_horizontal = Control.SIZE_EXPAND_FILL
		field.suffix = "px"
		_custom_size.add_child(field)
	_custom_size.name = "CustomSize"
	_backgrounds.name = "Background"
	for text: String in ["As Shown", "Transparent", "Custom Color"]:
		_backgrounds.add_item(text)
	_color.custom_minimum_size.y = 24.0 * PlaygroundStyle.scale()
	_color.edit_alpha = false
	_sizes.item_selected.connect(func(_index: int) -> void: _show_fields())
	_backgrounds.item_selected.connect(func(_index: int) -> void: _show_fields())
	_show_fields()


# Hides fields that do not apply, with their labels.
func _show_fields() -> void:
	for field: Control in [_custom_size, _color]:
		var is_needed := (
			_sizes.selected == Size.CUSTOM
			if field == _custom_size
			else _backgrounds.selected == Background.COLOR
		)
		field.visible = is_needed
		(field.get_parent().get_child(field.get_index() - 1) as Control).visible = is_needed
	reset_size()
