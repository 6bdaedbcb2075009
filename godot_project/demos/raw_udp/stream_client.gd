extends RefCounted
## Joins a stream server and receives its stream.

const CookieHandshake := preload("cookie_handshake.gd")

## Seconds between two attempts to join.
const JOIN_INTERVAL := 0.2

var receiver := MotorReceiver.new()

var _socket := PacketPeerUDP.new()
## What asks the server for the stream: a hello, then a join with the server's cookie.
var _request := CookieHandshake.make_hello()
var _requested_at := -INF
var _heard_at := -INF


func join(address: String, port: int) -> Error:
	return _socket.connect_to_host(address, port)


## Processes packets, sends requests and acknowledgements, and advances playback. [param now] is
## that of a monotonic clock, in seconds. Call it each frame.
func update(now: float) -> void:
	while _socket.get_available_packet_count() > 0:
		_accept(_socket.get_packet(), now)
	if now - _heard_at > 10.0 * JOIN_INTERVAL and now - _requested_at > JOIN_INTERVAL:
		_requested_at = now
		_socket.put_packet(_request)
	receiver.advance(now)
	var ack := receiver.take_ack(now)
	if not ack.is_empty():
		_socket.put_packet(PackedByteArray([CookieHandshake.Kind.STREAM]) + ack)


func _accept(packet: PackedByteArray, now: float) -> void:
	if packet.is_empty():
		return
	if packet[0] != CookieHandshake.Kind.STREAM:
		var join_packet := CookieHandshake.make_join(packet)
		if not join_packet.is_empty():
			_request = join_packet
			_requested_at = -INF
		return
	_heard_at = now
	# When the server forgets this client, its cookie is too old.
	_request = CookieHandshake.make_hello()
	var error := receiver.accept(packet.slice(1), now)
	if not error.is_empty():
		push_warning("Rejected a packet: %s." % error)
