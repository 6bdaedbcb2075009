extends RefCounted
## The media time that a receiver shows, in server ticks: the server's clock as the earliest of
## the last datagrams tell it, minus the playback delay. It is slewed and never runs backwards.

const TICK_RATE := 60.0
## What a sender may take before a pose leaves: a whole span, one tick to see that it
## bends, and the ticks until the next datagram.
const SENDER_TICKS := 9.0
## Limits of what is added for jitter, in ticks.
const LEAST_MARGIN := 1.0
const MOST_MARGIN := 15.0
## Playback runs at most this much faster to follow the server's clock, and at most this much slower:
## ahead of what has arrived there is nothing to show.
const FASTER := 0.1
const SLOWER := 0.5
## Share of its distance from the target that playback makes good with each tick.
const GAIN := 0.05
## Farther behind than this, in ticks, playback jumps ahead.
const JUMP := 45.0
## Datagrams' ticks in a window; the earliest of this and the last window sets the clock.
const WINDOW := 10
## Share of the recent lateness that the next tick still reckons with.
const LATENESS_KEPT := 0.98

## Local seconds at which tick 0 would have arrived: in this window, in the last one, the earlier.
var _earliest := 0.0
var _earliest_before := 0.0
var _offset := 0.0
var _ticks_in_window := 0
## How much later than the earliest a datagram recently came, in seconds; decays.
var _lateness := 0.0
var _newest_tick := -1
var _position := 0.0
var _last_local := 0.0


func is_running() -> bool:
	return _newest_tick >= 0


## A datagram that the server sent at [param tick] arrived at [param local] seconds.
func observe(tick: int, local: float) -> void:
	var sample := local - float(tick) / TICK_RATE
	if not is_running():
		_earliest = sample
		_earliest_before = sample
		_offset = sample
		_last_local = local
		_newest_tick = tick
		_position = float(tick) - get_delay_ticks()
		return
	if tick > _newest_tick:
		_newest_tick = tick
		_lateness *= LATENESS_KEPT
		_ticks_in_window += 1
		if _ticks_in_window == WINDOW:
			_ticks_in_window = 0
			_earliest_before = _earliest
			_earliest = sample
	_earliest = minf(_earliest, sample)
	_offset = minf(_earliest, _earliest_before)
	_lateness = clampf(sample - _offset, _lateness, MOST_MARGIN / TICK_RATE)


## The media time to show at [param local] seconds, in ticks.
func advance(local: float) -> float:
	var step := maxf(local - _last_local, 0.0) * TICK_RATE
	_last_local = local
	var target := (local - _offset) * TICK_RATE - get_delay_ticks()
	var behind := target - (_position + step)
	if behind > JUMP:
		_position = target
	else:
		_position += step * (1.0 + clampf(behind * GAIN, -SLOWER, FASTER))
	return _position


## The delay that playback aims at, in ticks.
func get_delay_ticks() -> float:
	return SENDER_TICKS + maxf(_lateness * TICK_RATE, LEAST_MARGIN)


## The delay that playback has at [param local] seconds, behind the earliest datagrams' arrival, in ms.
func get_delay_ms(local: float) -> float:
	return ((local - _offset) * TICK_RATE - _position) / TICK_RATE * 1000.0
