extends RefCounted
## Configures ENet connections and their timeouts.
##
## ENet disconnects a peer after a few retransmissions of one reliable packet without an
## acknowledgement. At 33% packet loss, this disconnects live peers within seconds. Therefore ENet
## gets long timeouts, and server and clients measure the silence of their peers themselves.

## Seconds of silence after which a peer counts as disconnected.
const MAX_SILENCE := 8.0
## ENet's timeouts in milliseconds.
const MIN_TIMEOUT := 20000
const MAX_TIMEOUT := 60000
## ENet's limit for 2 to the power of the number of retransmissions of a packet.
const TIMEOUT_LIMIT := 4096


## The message for a port at which no server can listen.
static func get_port_error(port: int) -> String:
	return (
		"Cannot listen on UDP port %d: it is in use or not permitted. Use --port to choose another."
		% port
	)


## Configures a new connection.
static func prepare(peer: ENetPacketPeer) -> void:
	peer.set_timeout(TIMEOUT_LIMIT, MIN_TIMEOUT, MAX_TIMEOUT)
	# Disable throttling: after one late frame ENet assumes a slow connection and drops unreliable
	# packets.
	peer.throttle_configure(5000, 32, 0)


## Makes ENet disconnect a silent peer soon.
static func expire(peer: ENetPacketPeer) -> void:
	peer.set_timeout(1, 200, 500)
