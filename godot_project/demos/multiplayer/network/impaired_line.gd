extends RefCounted
## One direction of an impaired network: a delay line for packets.
##
## In order: a bounded queue with limited rate, burst loss (Gilbert-Elliott model: the bad state
## loses every packet), delay, jitter, reordering, duplication. Each packet consumes the same number
## of random numbers under all conditions, so that runs with the same seed impair the n-th packet in
## the same way.

const LineConditions := preload("line_conditions.gd")

## Bytes of the IP and UDP headers.
const HEADER_BYTES := 28
## Maximum waiting time in the queue, in seconds. Packets beyond it are dropped.
const MAX_QUEUE := 0.25
## Additional delay of a reordered packet, in seconds.
const REORDER_DELAY := 0.04
## Maximum number of packets in transit.
const MAX_IN_TRANSIT := 8192

## May change at any time. Packets in transit are not affected.
var conditions := LineConditions.new()
## Packets that entered, and their bytes.
var packets := 0
var bytes := 0
## Packets lost at random, and packets dropped because a limit was reached.
var lost := 0
var overflowed := 0

var _random := RandomNumberGenerator.new()
var _is_bad := false
## Time at which the queue is empty, in seconds.
var _free_at := -INF
## Packets in transit and their arrival times, sorted by time.
var _in_transit: Array[PackedByteArray] = []
var _arrival_times := PackedFloat64Array()


func _init(seed_value: int) -> void:
	_random.seed = seed_value


## Sends a packet at the time [param now], in seconds.
func put(packet: PackedByteArray, now: float) -> void:
	packets += 1
	bytes += packet.size()
	var chance := _random.randf()
	var jitter_factor := _random.randf()
	var is_reordered := _random.randf() < conditions.reorder
	var is_duplicated := _random.randf() < conditions.duplicate
	var duplicate_jitter := _random.randf()
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
	_schedule(
		packet,
		arrives + jitter_factor * conditions.jitter + (REORDER_DELAY if is_reordered else 0.0)
	)
	if is_duplicated:
		_schedule(packet, arrives + duplicate_jitter * conditions.jitter)


## Removes and returns the packets that have arrived by [param now], in order of arrival.
func take(now: float) -> Array[PackedByteArray]:
	var count := _arrival_times.bsearch(now, false)
	if count == 0:
		return []
	var arrived := _in_transit.slice(0, count)
	_in_transit = _in_transit.slice(count)
	_arrival_times = _arrival_times.slice(count)
	return arrived


## Advances the state and returns whether the packet is lost. The share of the bad state is
## [code]loss[/code], and its mean length [code]burst[/code] packets.
func _loses(chance: float) -> bool:
	var loss := conditions.loss
	if loss <= 0.0 or loss >= 1.0:
		_is_bad = loss > 0.0
		return _is_bad
	# Independent losses have a mean burst length of 1 / (1 - loss).
	var mean_burst := maxf(conditions.burst, 1.0 / (1.0 - loss))
	_is_bad = chance < (1.0 - 1.0 / mean_burst if _is_bad else loss / ((1.0 - loss) * mean_burst))
	return _is_bad


func _schedule(packet: PackedByteArray, arrives: float) -> void:
	if _arrival_times.size() >= MAX_IN_TRANSIT:
		overflowed += 1
		return
	var index := _arrival_times.bsearch(arrives, false)
	_arrival_times.insert(index, arrives)
	_in_transit.insert(index, packet)
