@tool
extends ConfirmationDialog
## Edits the range and step of an entry's slider.

const PlaygroundDocument := preload("../document/playground_document.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")
const EntryEdits := preload("../document/entry_edits.gd")
const ValueSlider := preload("value_slider.gd")

const TITLES: Dictionary[String, String] = {
	ValueSlider.MIN: "From", ValueSlider.MAX: "To", ValueSlider.STEP: "Step"
}
const WIDTH := 220.0

var _document: PlaygroundDocument
var _edits: EntryEdits
var _entry := ""
var _fields: Dictionary[String, LineEdit] = {}
var _error := Label.new()


func _init(document: PlaygroundDocument, edits: EntryEdits) -> void:
	name = "SliderRange"
	_document = document
	_edits = edits
	ok_button_text = "Set"
	var column := VBoxContainer.new()
	add_child(column)
	var grid := GridContainer.new()
	grid.columns = 2
	column.add_child(grid)
	for key in TITLES:
		var heading := Label.new()
		heading.text = TITLES[key]
		grid.add_child(heading)
		_fields[key] = LineEdit.new()
		_fields[key].name = TITLES[key]
		_fields[key].size_flags_horizontal = Control.SIZE_EXPAND_FILL
		_fields[key].select_all_on_focus = true
		_fields[key].text_changed.connect(_on_text_changed)
		register_text_enter(_fields[key])
		grid.add_child(_fields[key])
	_error.name = "Error"
	_error.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_error.custom_minimum_size.x = WIDTH * PlaygroundStyle.scale()
	column.add_child(_error)
	confirmed.connect(_on_confirmed)


func ask(entry: String) -> void:
	_entry = entry
	title = "Slider Range of %s" % entry
	var values := ValueSlider.get_range(_document.scene, entry)
	for key in _fields:
		_fields[key].text = String.num(values[key]).trim_suffix(".0")
	_show_error()
	popup_centered()
	_fields[ValueSlider.MIN].grab_focus()


func _on_confirmed() -> void:
	if _find_error().is_empty():
		_edits.set_slider_range(_entry, _read())


func _on_text_changed(_text: String) -> void:
	_show_error()


func _show_error() -> void:
	_error.text = _find_error()
	_error.add_theme_color_override(&"font_color", get_theme_color(&"error_color", &"Editor"))
	get_ok_button().disabled = not _error.text.is_empty()


func _find_error() -> String:
	for key in _fields:
		if not _fields[key].text.strip_edges().is_valid_float():
			return "%s must be a number." % TITLES[key]
	var values := _read()
	if not values[ValueSlider.MIN] < values[ValueSlider.MAX]:
		return "From must be less than To."
	if not (
		values[ValueSlider.STEP] > 0.0
		and values[ValueSlider.STEP] <= values[ValueSlider.MAX] - values[ValueSlider.MIN]
	):
		return "Step must be greater than 0 and at most To minus From."
	return ""


func _read() -> Dictionary[String, float]:
	var values: Dictionary[String, float] = {}
	for key in _fields:
		values[key] = _fields[key].text.to_float()
	return values
