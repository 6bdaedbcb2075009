@tool
extends RefCounted
## Where t is while it is played.

const THERE_AND_BACK := "there and back"
const LOOP := "loop"
const ONCE := "once"
const TITLES: Dictionary[String, String] = {
	THERE_AND_BACK: "There and back", LOOP: "Loop", ONCE: "Once"
}

var is_playing := false

## 0 to 1 is there, 1 to 2 is back.
var _phase := 0.0


## On from t; from the start where there is nothing more to come.
func start(t: float, repeat: String) -> void:
	is_playing = true
	_phase = clampf(t, 0.0, 1.0)
	if repeat != THERE_AND_BACK and _phase >= 1.0:
		_phase = 0.0


func stop() -> void:
	is_playing = false


## t after that many seconds.
func advance(delta: float, duration: float, repeat: String) -> float:
	_phase += delta / duration
	match repeat:
		THERE_AND_BACK:
			_phase = fposmod(_phase, 2.0)
			return 1.0 - absf(1.0 - _phase)
		LOOP:
			_phase = fposmod(_phase, 1.0)
			return _phase
		_:
			is_playing = is_playing and _phase < 1.0
			return minf(_phase, 1.0)
