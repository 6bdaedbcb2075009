@tool
extends MenuButton
## The File menu: new, open, save, clipboard and picture export.

## Emitted when the user chooses to export a picture.
signal picture_requested

enum Item { NEW, OPEN, SAVE, SAVE_AS, COPY_JSON, PASTE, PICTURE }

const PlaygroundDocument := preload("../document/playground_document.gd")
const EntryEdits := preload("../document/entry_edits.gd")
const PlaygroundHost := preload("../playground_host.gd")
const SafeFile := preload("../document/safe_file.gd")
const SceneFile := preload("../document/scene_file.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")

## A scene or a ganja.js element, which is an array of 32 numbers or an object with keys 0 to 31.
const PASTED_TYPES: Array[Variant.Type] = [TYPE_ARRAY, TYPE_DICTIONARY]

## From Godot 4.6. In older versions, the dialog is centered at this size, at most at this share of
## the window.
const POPUP_METHOD := &"popup_file_dialog"
const DIALOG_SIZE := Vector2(1050.0, 700.0)
const MAX_SCREEN_SHARE := 0.8

var _document: PlaygroundDocument
var _edits: EntryEdits
var _host: PlaygroundHost
var _files: FileDialog
var _question := ConfirmationDialog.new()
var _pending_action := Callable()


func _init(document: PlaygroundDocument, edits: EntryEdits, host: PlaygroundHost) -> void:
	name = "File"
	text = "File"
	flat = true
	_document = document
	_edits = edits
	_host = host
	_files = host.make_file_dialog()
	var menu := get_popup()
	menu.add_item("New", Item.NEW)
	menu.add_item("Open...", Item.OPEN)
	menu.add_separator()
	menu.add_item("Save", Item.SAVE)
	menu.add_item("Save As...", Item.SAVE_AS)
	menu.add_separator()
	menu.add_item("Copy JSON", Item.COPY_JSON)
	menu.add_item("Paste JSON or 32 Numbers", Item.PASTE)
	menu.add_separator()
	menu.add_item("Export Picture...", Item.PICTURE)
	menu.id_pressed.connect(_on_item_pressed)
	_files.name = "Files"
	_files.add_filter("*.tres", "GAScene")
	_files.add_filter("*.json", "GAScene as JSON")
	_files.file_selected.connect(_on_file_selected)
	add_child(_files)
	_question.name = "Question"
	_question.dialog_text = "The playground has unsaved changes. Discard them?"
	_question.ok_button_text = "Discard"
	_question.confirmed.connect(_discard)
	add_child(_question)


## Shows the scene in a .tres or .json file. Reports errors through the host.
func open(path: String) -> void:
	if path.get_extension() == "json":
		_open_json(path)
		return
	var resource := ResourceLoader.load(path) if ResourceLoader.exists(path) else null
	if resource is GAScene:
		_show(resource as GAScene, path)
	elif resource != null:
		_warn(
			(
				"%s contains a %s. The playground opens GAScene files (.tres or .json)."
				% [path, resource.get_class()]
			)
		)
	else:
		_warn("%s cannot be read. See the Output panel for the reason." % path)


func _open_json(path: String) -> void:
	var scene := GAScene.new()
	var failure := SceneFile.load_json(path, scene)
	if failure.is_empty():
		_show(scene, path)
	else:
		_warn(failure)


# A partly read scene gets no path, so that saving it does not overwrite the file.
func _show(scene: GAScene, path: String) -> void:
	var errors := scene.get_load_errors()
	if errors.is_empty():
		_document.show_scene(scene, path)
		return
	var copy := GAScene.new()
	copy.document = scene.document
	_document.show_scene(copy, "")
	_warn(
		(
			"%s was only partly read and is shown as a new scene. The file is unchanged:\n%s"
			% [path, "\n".join(errors)]
		)
	)


func save(path: String) -> void:
	var outcome := OK
	if path.get_extension() == "json":
		outcome = SafeFile.write(path, _document.scene.to_json().to_utf8_buffer())
	else:
		outcome = SafeFile.save_resource(path, _document.scene)
	if outcome != OK:
		_warn(
			(
				(
					"%s cannot be saved: %s. What was saved before is unchanged."
					+ " Check the free space on the disk, or choose another location with Save As."
				)
				% [path, error_string(outcome)]
			)
		)
		return
	_document.mark_saved(path)
	_host.on_file_written(path)


func save_or_ask() -> void:
	if _document.path.is_empty():
		_ask_for_file(FileDialog.FILE_MODE_SAVE_FILE)
	elif _document.is_embedded():
		_host.save_containing_scene(_document.get_file())
	else:
		save(_document.path)


## Adds a ganja.js element as an entry. Replaces the current scene if the text is a scene; the user
## can undo this.
func paste(text: String) -> void:
	if text.length() > SceneFile.MAX_LENGTH:
		_warn(
			(
				"The clipboard has %d characters, and at most %d can be pasted."
				% [text.length(), SceneFile.MAX_LENGTH]
			)
		)
		return
	var parsed := JSON.new()
	if parsed.parse(text) != OK or not typeof(parsed.data) in PASTED_TYPES:
		_warn(
			(
				"The clipboard contains neither a playground scene as JSON nor a list of 32 numbers."
				+ " Copy one of them first."
			)
		)
		return
	if parsed.data is Dictionary and (parsed.data as Dictionary).has("entries"):
		_document.change("Paste JSON", func(scene: GAScene) -> void: scene.load_json(text))
		var errors := _document.scene.get_load_errors()
		if not errors.is_empty():
			_warn("The clipboard was not read completely:\n%s" % "\n".join(errors))
	else:
		_edits.add("", text.strip_edges())


func _on_item_pressed(item: int) -> void:
	match item:
		Item.NEW:
			confirm_discard(func() -> void: _document.show_scene(GAScene.new(), ""))
		Item.OPEN:
			confirm_discard(_ask_for_file.bind(FileDialog.FILE_MODE_OPEN_FILE))
		Item.SAVE:
			save_or_ask()
		Item.SAVE_AS:
			_ask_for_file(FileDialog.FILE_MODE_SAVE_FILE)
		Item.COPY_JSON:
			DisplayServer.clipboard_set(_document.scene.to_json())
		Item.PASTE:
			paste(DisplayServer.clipboard_get())
		Item.PICTURE:
			picture_requested.emit()


## Calls `action`. If there are unsaved changes, first asks the user whether to discard them.
func confirm_discard(action: Callable) -> void:
	if _document.is_embedded() or not _document.is_unsaved():
		action.call()
		return
	_pending_action = action
	_question.popup_centered()


# Nodes may use the same scene resource, and must not keep the discarded changes.
func _discard() -> void:
	if not _document.path.is_empty():
		_document.scene.document = _document.get_saved_text()
	_pending_action.call()


func _ask_for_file(mode: FileDialog.FileMode) -> void:
	_files.file_mode = mode
	if _files.has_method(POPUP_METHOD):
		_files.call(POPUP_METHOD)
	else:
		_files.popup_centered_clamped(DIALOG_SIZE * PlaygroundStyle.scale(), MAX_SCREEN_SHARE)


func _on_file_selected(path: String) -> void:
	if _files.file_mode == FileDialog.FILE_MODE_OPEN_FILE:
		open(path)
	else:
		save(path)


func _warn(message: String) -> void:
	_host.warn(message)
