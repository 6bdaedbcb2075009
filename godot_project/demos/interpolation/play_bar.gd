extends PanelContainer
## The bottom bar: a slider for the factor, and ping-pong playback.

signal factor_changed(factor: float)

## Seconds from one pose to the other.
const DURATION := 2.5

## Phase of the playback, 0 to 2: forward up to 1, then back.
var _phase := 0.0

@onready var _play: Button = %Play
@onready var _factor: HSlider = %Factor
@onready var _value: Label = %Value


func _ready() -> void:
	_play.toggled.connect(set_playing)
	_factor.value_changed.connect(_on_factor_changed)
	_factor.drag_started.connect(set_playing.bind(false))
	set_process(false)


func _process(delta: float) -> void:
	_phase = fposmod(_phase + delta / DURATION, 2.0)
	# Ease in and out at both ends.
	_factor.value = smoothstep(0.0, 1.0, 1.0 - absf(1.0 - _phase))


func get_factor() -> float:
	return _factor.value


func set_factor(factor: float) -> void:
	_factor.value = factor


func is_playing() -> bool:
	return is_processing()


## Plays from the current factor, or pauses there.
func set_playing(playing: bool) -> void:
	if playing and not is_processing():
		_phase = _phase_of(_factor.value)
	set_process(playing)
	_play.set_pressed_no_signal(playing)
	_play.text = "Pause" if playing else "Play"


func _on_factor_changed(factor: float) -> void:
	_value.text = "%.3f" % factor
	factor_changed.emit(factor)


## The inverse of smoothstep(0, 1, phase).
func _phase_of(factor: float) -> float:
	return 0.5 - sin(asin(1.0 - 2.0 * factor) / 3.0)
