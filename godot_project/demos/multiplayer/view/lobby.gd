extends Control
## The lobby: host a server on this machine, or join one.

## Emitted when the player hosts or joins. The options then contain the player's choices.
signal chosen

const CameraRig := preload("camera_rig.gd")
const CubesView := preload("cubes_view.gd")
const Layout := preload("../world/layout.gd")
const Options := preload("../options.gd")
const Ports := preload("../network/ports.gd")
const Stage := preload("stage.gd")

const SCENE := "res://demos/multiplayer/multiplayer.tscn"
const SCENE_TITLES: Dictionary[String, String] = {
	"cubes": "Falling Structures", "push": "Field of Cubes", "avatars": "Avatars"
}
const COLUMN_WIDTH := 400
## Rotation of the background in radians per second.
const ROTATION_SPEED := 0.06

var _options: Options
var _name := LineEdit.new()
var _address := LineEdit.new()
var _rig: CameraRig
var _background: Node3D


func _init(options: Options, message: String) -> void:
	_options = options
	# Only hosting chooses a server of a certain run.
	options.session = ""
	set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	_add_background()
	# On the left, so that the scene stays visible.
	var center := CenterContainer.new()
	center.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	center.anchor_right = 0.5
	add_child(center)
	var column := VBoxContainer.new()
	column.custom_minimum_size.x = COLUMN_WIDTH
	column.add_theme_constant_override("separation", 12)
	var panel := PanelContainer.new()
	center.add_child(panel)
	var margin := MarginContainer.new()
	for side: String in ["left", "top", "right", "bottom"]:
		margin.add_theme_constant_override("margin_" + side, 14)
	panel.add_child(margin)
	margin.add_child(column)
	_add_label(column, "Multiplayer", &"TitleLabel")
	_add_label(
		column,
		"A server simulates cubes, or forwards the players' avatars, as quantized motors.",
		&"CaptionLabel"
	)
	if not message.is_empty():
		_add_label(column, message, &"HeadingLabel")
	_name.text = options.player_name
	_name.placeholder_text = "Player"
	_name.max_length = 24
	_address.text = "%s:%d" % [options.address, options.port]
	_add_field(column, "Name", _name)
	_add_field(column, "Server", _address)
	_add_button(column, "Join", _on_join)
	_add_scenes(column)
	_add_button(column, "Host on This Machine and Play", _on_host)


func _process(delta: float) -> void:
	_rig.yaw += ROTATION_SPEED * delta


## Shows the initial state of the scene as the background.
func _add_background() -> void:
	var layout := Layout.new(_options.scene, _options.cubes)
	_background = Node3D.new()
	var yaw := _rig.yaw if _rig != null else CameraRig.YAW
	_rig = CameraRig.new(layout.half_extent)
	_rig.yaw = yaw
	# The panel is on the left.
	_rig.free_area = Rect2(0.46, 0.0, 0.54, 1.0)
	_background.add_child(Stage.new(_options.scene, layout.half_extent))
	_background.add_child(CubesView.new(layout, layout.poses.size()))
	_background.add_child(_rig)
	add_child(_background)


func _on_scene_chosen(scene: String) -> void:
	_options.scene = scene
	_options.cubes = Options.CUBES[scene]
	remove_child(_background)
	_background.queue_free()
	_add_background()


func _on_join() -> void:
	var parts := _address.text.strip_edges().rsplit(":", true, 1)
	_options.address = parts[0]
	if parts.size() > 1 and parts[1].is_valid_int():
		_options.port = clampi(parts[1].to_int(), 1, 65535)
	_play()


## Starts a server process that quits when the last player leaves. If the port is in use, for
## example by a server whose players were just killed, takes the next free one.
func _on_host() -> void:
	var port := Ports.find_free(_options.port)
	if port != 0 and port != _options.port:
		print("Port %d is in use. Hosting on port %d." % [_options.port, port])
		_options.port = port
	_options.session = "%d-%d" % [OS.get_process_id(), Time.get_ticks_usec()]
	var arguments: PackedStringArray = ["--headless"]
	if OS.has_feature("editor"):
		arguments.append_array(["--path", ProjectSettings.globalize_path("res://")])
	arguments.append_array(
		[
			SCENE,
			"--",
			"--role=server",
			"--quit-when-empty=on",
			"--port=%d" % _options.port,
			"--session=%s" % _options.session,
			"--scene=%s" % _options.scene,
			"--method=%s" % _options.method
		]
	)
	if _options.cubes > 0:
		arguments.append("--cubes=%d" % _options.cubes)
	OS.create_process(OS.get_executable_path(), arguments)
	_options.address = "127.0.0.1"
	_play()


func _play() -> void:
	_options.player_name = _name.text.strip_edges()
	chosen.emit()


func _add_label(column: VBoxContainer, text: String, variation: StringName) -> void:
	var label := Label.new()
	label.text = text
	label.theme_type_variation = variation
	label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	column.add_child(label)


func _add_field(column: VBoxContainer, text: String, field: LineEdit) -> void:
	var row := HBoxContainer.new()
	var label := Label.new()
	label.text = text
	label.custom_minimum_size.x = 96
	field.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	row.add_child(label)
	row.add_child(field)
	column.add_child(row)


func _add_scenes(column: VBoxContainer) -> void:
	var row := HBoxContainer.new()
	var group := ButtonGroup.new()
	for scene: String in SCENE_TITLES:
		var button := Button.new()
		button.text = SCENE_TITLES[scene]
		button.toggle_mode = true
		button.button_group = group
		button.button_pressed = scene == _options.scene
		button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
		button.pressed.connect(_on_scene_chosen.bind(scene))
		row.add_child(button)
	column.add_child(row)


func _add_button(column: VBoxContainer, text: String, action: Callable) -> void:
	var button := Button.new()
	button.text = text
	button.custom_minimum_size.y = 40
	button.pressed.connect(action)
	column.add_child(button)
