@tool
extends HSlider
## Slides an entry that is a number; hidden for all else.

const PlaygroundDocument := preload("playground_document.gd")

const PARAMETER := "value"
const LIMIT := 5.0
const STEP := 0.01

var _entry := ""
var _document: PlaygroundDocument


func _init(document: PlaygroundDocument) -> void:
	name = "Slider"
	_document = document
	step = STEP
	size_flags_horizontal = Control.SIZE_EXPAND_FILL
	scrollable = false
	drag_started.connect(_document.begin_gesture)
	drag_ended.connect(func(_has_changed: bool) -> void: _document.end_gesture("Slide %s" % _entry))
	value_changed.connect(_on_value_changed)


func show_entry(entry: String) -> void:
	_entry = entry
	var parameters := _document.scene.get_parameters(entry)
	visible = parameters.has(PARAMETER)
	if visible and not _document.is_in_gesture():
		var number: float = parameters[PARAMETER]
		set_block_signals(true)
		min_value = minf(-LIMIT, number)
		max_value = maxf(LIMIT, number)
		set_block_signals(false)
		set_value_no_signal(number)


func _on_value_changed(number: float) -> void:
	if _document.is_in_gesture():
		_document.scene.set_parameter(_entry, PARAMETER, number)
	else:
		_document.change("Slide %s" % _entry, func(scene: GAScene) -> void: scene.set_parameter(_entry, PARAMETER, number))
