extends RefCounted
## How server and clients set up ENet.

## Channels that the RPCs use besides the engine's own.
const CHANNELS := 4
## Milliseconds without an answer after which a peer is gone.
const TIMEOUT_LEAST := 3000
const TIMEOUT_MOST := 6000
## Lost reliable packets in a row that count as no answer.
const TIMEOUT_LIMIT := 32


## Prepares a connection that has just been made.
static func prepare(peer: ENetPacketPeer) -> void:
	peer.set_timeout(TIMEOUT_LIMIT, TIMEOUT_LEAST, TIMEOUT_MOST)
	# ENet throws unreliable packets away when it thinks the line is slow; a late frame is enough for that.
	peer.throttle_configure(5000, 32, 0)
