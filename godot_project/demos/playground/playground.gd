extends Control
## The playground in a running game: the panel of the editor's dock beside a view of its objects.

const GameHost := preload("res://addons/ga_godot/playground/game_host.gd")
const LabDrawing := preload("res://addons/ga_godot/playground/lab/lab_drawing.gd")
const NewObjects := preload("res://addons/ga_godot/playground/document/new_objects.gd")
const PlaygroundPanel := preload("res://addons/ga_godot/playground/playground_panel.gd")
const PlaygroundTheme := preload("res://addons/ga_godot/playground/theme/playground_theme.gd")
const SceneDrawing := preload("res://addons/ga_godot/playground/view/scene_drawing.gd")
const ViewPoint := preload("res://addons/ga_godot/playground/picture/view_point.gd")
const ViewPointer := preload("res://addons/ga_godot/playground/view/view_pointer.gd")
const AddingMenu := preload("adding_menu.gd")
const Extent := preload("extent.gd")
const Ground := preload("ground.gd")
const SavedState := preload("saved_state.gd")
const Notice := preload("notice.gd")
const OrbitCamera := preload("res://demos/shared/orbit_camera.gd")
const ViewOverlay := preload("view_overlay.gd")
const ViewPane := preload("view_pane.gd")

const KEYS := (
	"Drag: move objects   ·   Right drag: orbit   ·   Middle drag: pan   ·   Wheel: zoom   ·   "
	+ "F: frame   ·   Ctrl+Z: undo   ·   Esc: menu"
)
const ADDING_KEYS := "Click: add %s   ·   Ctrl: snap   ·   Esc: stop"
const PANEL_WIDTH := 340
const LIGHT := "light"
const WIDTH := "width"
## Minimum radius of the framed sphere, in meters, for objects without a size.
const MIN_FRAME := 1.2
const FRAME_MARGIN := 1.05
## The document of the first session.
const FIRST_ENTRIES: Dictionary[String, String] = {
	"A": "point(-1.6, 0.2, 1)",
	"B": "point(1.5, 0.4, 1.2)",
	"C": "point(0.2, 2.5, -0.8)",
	"k": "circle(A, B, C)",
	"S": "sphere(point(1, 1.3, 0), 1.2)",
	"P": "meet(k, S)",
	"l": "A ^ B ^ einf",
}

## The file of the state that persists between sessions; empty for none.
var state_path := "user://playground.cfg"
var host := GameHost.new()
var panel: PlaygroundPanel

var _state: SavedState
var _is_light := false
var _drawing := SceneDrawing.new()
var _pointer: ViewPointer
var _adding_menu := AddingMenu.new()
var _shown_scene: GAScene
var _undo_button := Button.new()
var _redo_button := Button.new()
var _frame_button := Button.new()
var _light_button := Button.new()

@onready var _split: HSplitContainer = $Split
@onready var _side: PanelContainer = %Side
@onready var _view: ViewPane = %View
@onready var _camera: OrbitCamera = %View/Viewport/OrbitCamera
@onready var _ground: Ground = %View/Viewport/Ground
@onready var _world: WorldEnvironment = %View/Viewport/WorldEnvironment
@onready var _overlay: ViewOverlay = %View/Overlay
@onready var _keys: Label = %Keys
@onready var _notice: Notice = %Notice


func _ready() -> void:
	_state = SavedState.new(state_path)
	_make_panel()
	_make_view()
	_camera.moved.connect(_on_camera_moved)
	_on_camera_moved()
	set_light(_state.get_setting(LIGHT, false) as bool)
	_split.split_offset = _state.get_setting(WIDTH, PANEL_WIDTH) as int
	if _state.has_document():
		_state.restore(panel.document)
		_frame_scene()
	else:
		_show_first_entries()


func _exit_tree() -> void:
	_state.save(panel.document, {LIGHT: _is_light, WIDTH: _split.split_offset})


## Switches between the light and the dark theme.
func set_light(light: bool) -> void:
	_is_light = light
	theme = PlaygroundTheme.make(light)
	var colors := PlaygroundTheme.palette(light)
	host.background = colors[&"view"]
	_world.environment.background_color = colors[&"view"]
	_ground.set_light(light)
	_drawing.on_light = light
	_undo_button.icon = theme.get_icon(&"Undo", &"EditorIcons")
	_redo_button.icon = theme.get_icon(&"Redo", &"EditorIcons")
	_frame_button.icon = theme.get_icon(&"Frame", &"EditorIcons")
	_light_button.icon = theme.get_icon(&"Moon" if light else &"Sun", &"EditorIcons")


func undo() -> void:
	var title := host.own_history.undo()
	if not title.is_empty():
		_notice.show_text("Undo: %s" % title)


func redo() -> void:
	var title := host.own_history.redo()
	if not title.is_empty():
		_notice.show_text("Redo: %s" % title)


func get_viewport_camera() -> Camera3D:
	return _camera.camera


## The current message, or an empty string.
func get_notice() -> String:
	return _notice.get_text()


## Fits the selected entries into the view, or all if none is selected.
func frame_selection() -> void:
	_frame(
		(
			panel.list.selection
			if not panel.list.selection.is_empty()
			else panel.document.scene.get_names()
		)
	)


func _frame(entries: PackedStringArray) -> void:
	var box := Extent.of(panel.document.scene, entries)
	if box.has_volume():
		_camera.frame(box.get_center(), maxf(box.size.length() / 2.0 * FRAME_MARGIN, MIN_FRAME))


func _make_view() -> void:
	_view.viewport.add_child(_drawing)
	_view.viewport.add_child(LabDrawing.new(panel.lab))
	_pointer = ViewPointer.new(_drawing, panel.document, panel.edits, panel.list)
	_pointer.double_click_adds = &"point"
	_pointer.adding_changed.connect(_show_keys)
	_view.first_listener = _pointer.handle_input.bind(_camera.camera)
	_view.mouse_exited.connect(_pointer.clear_mouse)
	_overlay.show_pointer(_pointer, _camera.camera)
	_adding_menu.chosen.connect(func(kind: StringName) -> void: _pointer.adding = kind)
	host.camera = _camera.camera
	_show_keys()


func _make_panel() -> void:
	panel = PlaygroundPanel.new(host)
	_side.add_child(panel)
	panel.document.scene_switched.connect(_on_scene_switched)
	host.warned.connect(_notice.show_text)
	host.own_history.changed.connect(_show_history)
	_add_button(_undo_button, "Undo", "Undo (Ctrl+Z).", undo, panel.add_to_toolbar)
	_add_button(_redo_button, "Redo", "Redo (Ctrl+Shift+Z).", redo, panel.add_to_toolbar)
	%Tools.add_child(_adding_menu)
	_add_button(
		_frame_button, "Frame", "Frame the selection (F).", frame_selection, %Tools.add_child
	)
	_add_button(
		_light_button,
		"Light",
		"Switch between the light and dark themes.",
		func() -> void: set_light(not _is_light),
		%Tools.add_child
	)
	_show_history()


func _add_button(
	button: Button, title: String, hint: String, action: Callable, add: Callable
) -> void:
	button.name = title
	button.tooltip_text = hint
	button.theme_type_variation = &"FlatButton"
	button.focus_mode = Control.FOCUS_NONE
	button.pressed.connect(action)
	add.call(button)


## Undo and redo apply to the document even if an empty text field has the focus.
func _input(event: InputEvent) -> void:
	var key := event as InputEventKey
	var line := get_viewport().gui_get_focus_owner() as LineEdit
	if (
		key != null
		and key.pressed
		and key.is_command_or_control_pressed()
		and key.keycode in [KEY_Z, KEY_Y]
		and line != null
		and line.text.is_empty()
	):
		_press_key(key)
		get_viewport().set_input_as_handled()


func _unhandled_key_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if key == null or not key.pressed:
		return
	if _press_key(key) or panel.list.press_key(key):
		get_viewport().set_input_as_handled()


func _press_key(key: InputEventKey) -> bool:
	if key.is_command_or_control_pressed():
		match key.keycode:
			KEY_Z when not key.shift_pressed:
				undo()
			KEY_Z, KEY_Y:
				redo()
			KEY_S:
				panel.file_menu.save_or_ask()
			_:
				return false
		return true
	if key.keycode == KEY_F:
		frame_selection()
		return true
	if _pointer.handle_input(key, _camera.camera):
		return true
	if key.is_action_pressed(&"ui_cancel") and not panel.list.selection.is_empty():
		panel.list.select(PackedStringArray())
		return true
	return false


func _on_scene_switched() -> void:
	if _shown_scene != panel.document.scene:
		_shown_scene = panel.document.scene
		host.own_history.clear()
		_frame_scene()


## Uses the camera stored in the document, or fits all objects into the view.
func _frame_scene() -> void:
	if ViewPoint.is_stored_in(_shown_scene):
		var view := ViewPoint.of(_shown_scene)
		_camera.camera.fov = view.fov_in(_view.size)
		_camera.look_from(view.from, view.to)
	else:
		_camera.reset()
		_frame(_shown_scene.get_names())


func _show_keys() -> void:
	_keys.text = (
		KEYS if _pointer.adding.is_empty() else ADDING_KEYS % NewObjects.TITLES[_pointer.adding]
	)


func _on_camera_moved() -> void:
	_ground.fit_to(_camera)
	_camera.camera.near = clampf(_camera.get_distance() * 0.01, 0.002, 0.1)
	host.camera_distance = _camera.get_distance()
	_overlay.queue_redraw()
	_camera.camera.far = maxf(_camera.get_distance() * 50.0, 1000.0)


func _show_history() -> void:
	_undo_button.disabled = not host.own_history.has_undo()
	_redo_button.disabled = not host.own_history.has_redo()


func _show_first_entries() -> void:
	var scene := GAScene.new()
	for entry in FIRST_ENTRIES:
		scene.add_entry(entry, FIRST_ENTRIES[entry])
	panel.document.show_scene(scene, "")
