extends RefCounted
## Network impairments in each direction; none by default.

## Share of lost packets, 0 to 1.
var loss := 0.0
## Mean number of consecutive lost packets; losses are independent at 1 / (1 - loss) and below.
var burst := 1.0
## Delay of every packet, in seconds.
var delay := 0.0
## Maximum of an additional, uniformly random delay of each packet, in seconds. It reorders packets.
var jitter := 0.0
## Share of packets that get an additional delay, so that later packets overtake them.
var reorder := 0.0
## Share of packets that arrive twice.
var duplicate := 0.0
## Maximum rate in bytes per second, including IP and UDP headers; 0 for no limit.
var rate := 0.0


func is_perfect() -> bool:
	return (
		loss <= 0.0
		and delay <= 0.0
		and jitter <= 0.0
		and reorder <= 0.0
		and duplicate <= 0.0
		and rate <= 0.0
	)
