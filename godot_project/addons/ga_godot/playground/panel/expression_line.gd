@tool
extends VBoxContainer
## Where expressions are typed: what they are, or what is wrong with them, is told while typing.

const PlaygroundDocument := preload("../document/playground_document.gd")
const EntryEdits := preload("../document/entry_edits.gd")

signal added(entry: String)

var _document: PlaygroundDocument
var _edits: EntryEdits
var _line := LineEdit.new()
var _words := Label.new()
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
	_line.text_changed.connect(_show_words)
	_line.text_submitted.connect(_on_submitted)
	add_child(_line)
	_words.name = "Words"
	_words.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_words.visible = false
	add_child(_words)


func _on_submitted(text: String) -> void:
	if text.strip_edges().is_empty() or not _error_of(text).is_empty():
		return
	var parts := _split(text)
	_line.clear()
	_words.visible = false
	added.emit(_edits.add(parts[0], parts[1].strip_edges()))


func _show_words(text: String) -> void:
	var error := _error_of(text)
	_words.visible = not text.strip_edges().is_empty()
	if not _words.visible:
		return
	_words.text = error if not error.is_empty() else _document.describe(_split(text)[1])
	_words.modulate = Color.WHITE if not error.is_empty() else Color(1, 1, 1, 0.65)
	if error.is_empty():
		_words.remove_theme_color_override(&"font_color")
	else:
		_words.add_theme_color_override(&"font_color", get_theme_color(&"error_color", &"Editor"))


func _error_of(text: String) -> String:
	var parts := _split(text)
	if not parts[0].is_empty() and not _document.name_error(parts[0]).is_empty():
		return _document.name_error(parts[0])
	return _document.scene.get_expression_error(parts[1])


## The name, empty if there is none, and the expression. What stands before the sign becomes spaces, so that columns are
## those of the line.
func _split(text: String) -> PackedStringArray:
	var found := _assignment.search(text)
	if found == null:
		return ["", text]
	return [found.get_string(1), " ".repeat(found.get_start(2)) + found.get_string(2)]
