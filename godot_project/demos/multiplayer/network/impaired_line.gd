extends RefCounted
## One direction of a bad network: takes packets in, and gives back at a later time what has arrived.
##
## In order: a bounded queue before the line's limited rate, loss in bursts (Gilbert and Elliott's two states: in the
## bad one every packet is lost), delay, jitter, reordering, duplication. Each packet takes the same number of random
## numbers whatever the conditions, so with one seed the n-th packet meets the same fate in every run.

const LineConditions := preload("line_conditions.gd")

## Bytes of IP and UDP that a packet costs besides its content.
const HEADER_BYTES := 28
## What waits longer than this for the line to be free is thrown away, in seconds.
const MAX_QUEUE := 0.25
## How much longer a reordered packet takes, in seconds.
const OVERTAKING := 0.04
## More packets than this are never held.
const MAX_HELD := 8192

## May be changed, or exchanged, at any time; packets on their way keep what they got.
var conditions := LineConditions.new()
## Packets, and bytes in them, that were put in.
var packets := 0
var bytes := 0
## Packets that were lost by chance, and that found the queue full.
var lost := 0
var overflowed := 0

var _random := RandomNumberGenerator.new()
var _is_bad := false
## Seconds at which all that was sent before has left.
var _free_at := -INF
## Packets on their way and when they arrive, the first first.
var _held: Array[PackedByteArray] = []
var _due := PackedFloat64Array()


func _init(seed_value: int) -> void:
	_random.seed = seed_value


## Takes a packet in at [param now] seconds.
func put(packet: PackedByteArray, now: float) -> void:
	packets += 1
	bytes += packet.size()
	var chance := _random.randf()
	var lateness := _random.randf()
	var is_overtaken := _random.randf() < conditions.reorder
	var is_doubled := _random.randf() < conditions.duplicate
	var double_lateness := _random.randf()
	var leaves := now
	if conditions.rate > 0.0:
		leaves = maxf(now, _free_at)
		if leaves - now > MAX_QUEUE:
			overflowed += 1
			return
		leaves += (packet.size() + HEADER_BYTES) / conditions.rate
		_free_at = leaves
	if _loses(chance):
		lost += 1
		return
	var arrives := leaves + conditions.delay
	_hold(packet, arrives + lateness * conditions.jitter + (OVERTAKING if is_overtaken else 0.0))
	if is_doubled:
		_hold(packet, arrives + double_lateness * conditions.jitter)


## The packets that have arrived by [param now] seconds, in the order of their arrival.
func take(now: float) -> Array[PackedByteArray]:
	var count := _due.bsearch(now, false)
	if count == 0:
		return []
	var arrived := _held.slice(0, count)
	_held = _held.slice(count)
	_due = _due.slice(count)
	return arrived


## Moves between the two states, and tells whether the packet is lost: with a share of [code]loss[/code] in the bad
## state, which is left after [code]burst[/code] packets on average.
func _loses(chance: float) -> bool:
	var loss := conditions.loss
	if loss <= 0.0 or loss >= 1.0:
		_is_bad = loss > 0.0
		return _is_bad
	# Chance alone makes rows of 1 / (1 - loss) packets.
	var row := maxf(conditions.burst, 1.0 / (1.0 - loss))
	_is_bad = chance < (1.0 - 1.0 / row if _is_bad else loss / ((1.0 - loss) * row))
	return _is_bad


func _hold(packet: PackedByteArray, arrives: float) -> void:
	if _due.size() >= MAX_HELD:
		overflowed += 1
		return
	var at := _due.bsearch(arrives, false)
	_due.insert(at, arrives)
	_held.insert(at, packet)
