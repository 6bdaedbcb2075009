extends PanelContainer
## The left panel: preset, mode and the two poses.

signal mode_chosen(mode: MultivectorLerp.Mode)
## Emitted when the user chooses a preset or moves a slider. get_start_pose() and get_end_pose()
## return the new poses.
signal poses_changed

const DemoPose := preload("res://demos/interpolation/demo_pose.gd")
const ModeCard := preload("res://demos/interpolation/mode_card.gd")
const Modes := preload("res://addons/ga_godot/playground/lab/interpolation_modes.gd")
const PoseEditor := preload("res://demos/interpolation/pose_editor.gd")
const Preset := preload("res://demos/interpolation/presets.gd")

const EDITED_HINT := "Edited. Choose a preset above to start over."

var _presets := Preset.list()
var _cards: Array[ModeCard] = []

@onready var _preset: OptionButton = %Preset
@onready var _preset_hint: Label = %PresetHint
@onready var _modes: VBoxContainer = %Modes
@onready var _start_tab: Button = %StartTab
@onready var _start_editor: PoseEditor = %StartEditor
@onready var _end_editor: PoseEditor = %EndEditor


func _ready() -> void:
	var group := ButtonGroup.new()
	for mode in Modes.COUNT:
		var card := ModeCard.new(mode, group)
		card.pressed.connect(_on_card_pressed.bind(mode))
		_modes.add_child(card)
		_cards.append(card)
	for preset in _presets:
		_preset.add_item(preset.title)
	_preset.item_selected.connect(choose_preset)
	_start_tab.toggled.connect(_on_start_tab_toggled)
	_start_editor.pose_changed.connect(_on_pose_edited)
	_end_editor.pose_changed.connect(_on_pose_edited)


func get_start_pose() -> DemoPose:
	return _start_editor.get_pose()


func get_end_pose() -> DemoPose:
	return _end_editor.get_pose()


## Selects a preset and emits poses_changed.
func choose_preset(index: int) -> void:
	var preset := _presets[index]
	_preset.select(index)
	_preset_hint.text = preset.hint
	_start_editor.show_pose(preset.start)
	_end_editor.show_pose(preset.end)
	poses_changed.emit()


## Selects the card of the mode without emitting mode_chosen.
func show_mode(mode: MultivectorLerp.Mode) -> void:
	_cards[mode].set_pressed_no_signal(true)


func _on_card_pressed(mode: int) -> void:
	mode_chosen.emit(mode as MultivectorLerp.Mode)


func _on_start_tab_toggled(pressed: bool) -> void:
	_start_editor.visible = pressed
	_end_editor.visible = not pressed


func _on_pose_edited() -> void:
	_preset_hint.text = EDITED_HINT
	poses_changed.emit()
