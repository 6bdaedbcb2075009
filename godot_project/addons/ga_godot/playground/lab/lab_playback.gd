@tool
extends RefCounted
## Advances t during playback.

const PING_PONG := "ping-pong"
const LOOP := "loop"
const ONCE := "once"
const TITLES: Dictionary[String, String] = {PING_PONG: "Ping-pong", LOOP: "Loop", ONCE: "Once"}

var is_playing := false

# From 0 to 1 forward, from 1 to 2 backward.
var _phase := 0.0


## Starts at t. At the end of the path, starts over from 0 unless the mode is ping-pong.
func start(t: float, repeat: String) -> void:
	is_playing = true
	_phase = clampf(t, 0.0, 1.0)
	if repeat != PING_PONG and _phase >= 1.0:
		_phase = 0.0


func stop() -> void:
	is_playing = false


## Returns t after `delta` seconds.
func advance(delta: float, duration: float, repeat: String) -> float:
	_phase += delta / duration
	match repeat:
		PING_PONG:
			_phase = fposmod(_phase, 2.0)
			return 1.0 - absf(1.0 - _phase)
		LOOP:
			_phase = fposmod(_phase, 1.0)
			return _phase
		_:
			is_playing = is_playing and _phase < 1.0
			return minf(_phase, 1.0)
