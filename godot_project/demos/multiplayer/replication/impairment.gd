extends RefCounted
## A bad network for one receiver, made at the entry of its datagrams: loses a share of them and
## holds the others back for a random time, so that they also change order. Seeded: the sequence of
## decisions repeats from run to run. Reliable messages pass.

var _loss: float
var _jitter: float
var _random := RandomNumberGenerator.new()
var _held: Array[PackedByteArray] = []
var _due := PackedFloat64Array()


## [param loss] in percent, [param jitter] in milliseconds (uniform from 0 to that).
func _init(loss: float, jitter: float, seed_value: int) -> void:
	_loss = loss / 100.0
	_jitter = jitter / 1000.0
	_random.seed = seed_value


## Takes a datagram in at [param local] seconds.
func put(bytes: PackedByteArray, local: float) -> void:
	if _random.randf() < _loss:
		return
	_held.append(bytes)
	_due.append(local + _random.randf() * _jitter)


## The datagrams that arrive by [param local] seconds.
func take(local: float) -> Array[PackedByteArray]:
	var arrived: Array[PackedByteArray] = []
	var at := 0
	while at < _held.size():
		if _due[at] > local:
			at += 1
			continue
		arrived.append(_held[at])
		_held.remove_at(at)
		_due.remove_at(at)
	return arrived
