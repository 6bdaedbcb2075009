@tool
extends MarginContainer
## The dock "GA Playground": named expressions of geometric algebra. From Godot 4.6, the object is
## an EditorDock; in older versions, it is a control in a dock slot of the editor.

const PlaygroundDocument := preload("../playground/document/playground_document.gd")
const PlaygroundIcons := preload("../playground/theme/playground_icons.gd")
const PlaygroundPanel := preload("../playground/playground_panel.gd")
const PlaygroundStyle := preload("../playground/theme/playground_style.gd")
const EditorHistory := preload("editor_history.gd")
const EditorHost := preload("editor_host.gd")
const EmbeddedScenes := preload("embedded_scenes.gd")
const Session := preload("session.gd")
const UndoKeys := preload("undo_keys.gd")

const DOCK_CLASS := &"EditorDock"
const TITLE := "GA Playground"
const WIDTH := 220.0

var document: PlaygroundDocument
var panel: PlaygroundPanel
var embedded: EmbeddedScenes


## Call this before adding the dock to the editor.
func set_up(undo_redo: EditorUndoRedoManager) -> void:
	if is_class(DOCK_CLASS):
		_set_up_dock()
	else:
		name = TITLE
	custom_minimum_size.x = WIDTH * PlaygroundStyle.scale()
	panel = PlaygroundPanel.new(EditorHost.new(undo_redo))
	document = panel.document
	add_child(panel)
	add_child(UndoKeys.new(self, document, panel.host.history as EditorHistory))
	embedded = EmbeddedScenes.new(document)
	Session.restore(document)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree():
		if is_class(DOCK_CLASS):
			set(&"dock_icon", PlaygroundIcons.make(&"intersect", self))


func show_scene(scene: GAScene) -> void:
	if scene != document.scene:
		panel.file_menu.confirm_discard(panel.show_scene.bind(scene))


## Call this when the editor has saved the file of an edited scene.
func on_scene_saved(path: String) -> void:
	embedded.on_scene_saved(path)


func on_scene_closed(path: String) -> void:
	embedded.on_scene_closed(path)


## Saves the scene to its file, if it has one, and the session for the next start of the editor.
func save_all() -> void:
	if document.path.get_extension() in ["tres", "json"] and document.is_unsaved():
		panel.file_menu.save(document.path)
	Session.save(document)


func save_session() -> void:
	Session.save(document)


func _set_up_dock() -> void:
	name = "GAPlayground"
	set(&"title", TITLE)
	set(&"layout_key", "ga_playground")
	set(&"default_slot", EditorPlugin.DOCK_SLOT_RIGHT_UL)
	var layouts := 0
	for layout: StringName in [&"DOCK_LAYOUT_VERTICAL", &"DOCK_LAYOUT_FLOATING"]:
		layouts |= ClassDB.class_get_integer_constant(DOCK_CLASS, layout)
	set(&"available_layouts", layouts)
	set(&"closable", true)
