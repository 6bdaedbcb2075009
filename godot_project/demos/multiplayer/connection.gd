extends RefCounted
## How server and clients set up ENet, and how they find out that the other is gone.
##
## ENet gives a peer up as soon as one reliable message was sent again a few times without an answer. On a network that
## loses a third, that comes to pass within seconds although the peer is there. So ENet is told to be patient, and both
## sides look at when they last heard anything at all.

## Seconds of silence after which the other is gone.
const MAX_SILENCE := 8.0
## Milliseconds for which ENet itself is patient with a peer.
const MIN_PATIENCE := 20000
const MAX_PATIENCE := 60000
## How often ENet sends a message again before it may lose patience: two to the power of the attempts.
const PATIENCE_LIMIT := 4096


## Prepares a connection that has just been made.
static func prepare(peer: ENetPacketPeer) -> void:
	peer.set_timeout(PATIENCE_LIMIT, MIN_PATIENCE, MAX_PATIENCE)
	# ENet throws unreliable packets away when it thinks the line is slow; a late frame is enough for that.
	peer.throttle_configure(5000, 32, 0)


## Lets ENet find out soon that a silent peer is gone.
static func give_up(peer: ENetPacketPeer) -> void:
	peer.set_timeout(1, 200, 500)
