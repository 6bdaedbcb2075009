extends RefCounted
## How bad a network is, in each direction. As it comes, nothing is bad.

## Share of the packets that vanish, 0 to 1.
var loss := 0.0
## Mean number of packets lost in a row. At 1, or anything that chance alone exceeds, each is lost by chance alone.
var burst := 1.0
## Seconds that every packet takes.
var delay := 0.0
## On top of it a random time, uniform from 0 to this many seconds, for each packet its own: so order changes too.
var jitter := 0.0
## Share of the packets that are held back a little longer, so that later ones overtake them.
var reorder := 0.0
## Share of the packets that arrive twice.
var duplicate := 0.0
## Bytes a second that pass, headers of IP and UDP included; 0: as many as come.
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
