@tool
extends VBoxContainer
## A text field for new entries. It shows the description or the error of the expression while it is
## being typed.

signal added(entry: String)

const PlaygroundDocument := preload("../document/playground_document.gd")
const EntryEdits := preload("../document/entry_edits.gd")

var _document: PlaygroundDocument
var _edits: EntryEdits
var _line := LineEdit.new()
var _message := Label.new()
var _assignment := RegEx.create_from_string("^\\s*([^\\s=()]+)\\s*=(.*)$")


func _init(document: PlaygroundDocument, edits: EntryEdits) -> void:
	name = "Typing"
	_document = document
	_edits = edits
	add_theme_constant_override(&"separation", 0)
	_line.name = "Line"
	_line.placeholder_text = "New: c = meet(A, B)"
	_line.clear_button_enabled = true
	_line.keep_editing_on_text_submit = true
	_line.text_changed.connect(_show_message)
	_line.text_submitted.connect(_on_submitted)
	add_child(_line)
	_message.name = "Message"
	_message.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_message.visible = false
	add_child(_message)


func _on_submitted(text: String) -> void:
	var error: String = _describe(text)["error"]
	if text.strip_edges().is_empty() or not error.is_empty():
		return
	var parts := _split(text)
	_line.clear()
	_message.visible = false
	added.emit(_edits.add(parts[0], parts[1].strip_edges()))


func _show_message(text: String) -> void:
	_message.visible = not text.strip_edges().is_empty()
	if not _message.visible:
		return
	var found := _describe(text)
	var error: String = found["error"]
	var is_wrong := not error.is_empty()
	_message.text = error if is_wrong else found["description"]
	_message.modulate = Color.WHITE if is_wrong else Color(1, 1, 1, 0.65)
	if is_wrong:
		_message.add_theme_color_override(&"font_color", get_theme_color(&"error_color", &"Editor"))
	else:
		_message.remove_theme_color_override(&"font_color")


## Returns the "description" and "error" of the entry that the text would add.
func _describe(text: String) -> Dictionary:
	var parts := _split(text)
	var name_error := "" if parts[0].is_empty() else _document.scene.get_name_error(parts[0])
	if not name_error.is_empty():
		return {"description": "", "error": name_error}
	return _document.scene.describe_expression(parts[1], parts[0])


## Returns the name, which may be empty, and the expression. Spaces before the expression keep its
## position, so that the columns in error messages match the text field.
func _split(text: String) -> PackedStringArray:
	var found := _assignment.search(text)
	if found == null:
		return ["", text]
	return [found.get_string(1), " ".repeat(found.get_start(2)) + found.get_string(2)]
