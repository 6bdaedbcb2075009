@tool
extends HSlider
## A slider for entries that are numbers; hidden for all others.

const PlaygroundDocument := preload("../document/playground_document.gd")

const PARAMETER := "value"
## Attributes of the entry, and their defaults.
const MIN := "slider/min"
const MAX := "slider/max"
const STEP := "slider/step"
const DEFAULTS: Dictionary[String, float] = {MIN: -5.0, MAX: 5.0, STEP: 0.01}

var _entry := ""
var _document: PlaygroundDocument


func _init(document: PlaygroundDocument) -> void:
	name = "Slider"
	_document = document
	size_flags_horizontal = Control.SIZE_EXPAND_FILL
	scrollable = false
	drag_started.connect(_document.begin_gesture)
	drag_ended.connect(func(_has_changed: bool) -> void: _document.end_gesture("Slide %s" % _entry))
	value_changed.connect(_on_value_changed)


## The range from the entry's attributes, with defaults for missing or invalid ones.
static func get_range(scene: GAScene, entry: String) -> Dictionary[String, float]:
	var found: Dictionary[String, float] = DEFAULTS.duplicate()
	for key in DEFAULTS:
		var own: Variant = scene.get_entry_attribute(entry, key)
		if (own is float or own is int) and is_finite(own as float):
			found[key] = own
	return found if found[MIN] < found[MAX] and found[STEP] > 0.0 else DEFAULTS


func show_entry(entry: String) -> void:
	_entry = entry
	var parameters := _document.scene.get_parameters(entry)
	visible = parameters.has(PARAMETER)
	if visible and not _document.is_in_gesture():
		var number: float = parameters[PARAMETER]
		var values := get_range(_document.scene, entry)
		set_block_signals(true)
		step = values[STEP]
		min_value = minf(values[MIN], number)
		max_value = maxf(values[MAX], number)
		set_block_signals(false)
		set_value_no_signal(number)


func _on_value_changed(number: float) -> void:
	if _document.is_in_gesture():
		_document.scene.set_parameter(_entry, PARAMETER, number)
	else:
		_document.change(
			"Slide %s" % _entry,
			func(scene: GAScene) -> void: scene.set_parameter(_entry, PARAMETER, number)
		)
