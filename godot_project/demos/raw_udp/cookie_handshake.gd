extends RefCounted
## Confirms that a client receives packets at the address from which it seems to send, before a
## server sends it a stream. Without this, one packet with a forged source address would make the
## server flood a stranger.
##
## The client sends a hello. The server replies with a cookie, a keyed hash of the address and the
## time, and stores nothing. The client returns the cookie in a join, which only a receiver of the
## cookie can. The reply is shorter than the hello, so that an attacker gains nothing.

## The first byte of each packet.
enum Kind { HELLO, COOKIE, JOIN, STREAM }

const COOKIE_SIZE := 16
## The hello is padded, so that the reply is shorter.
const HELLO_SIZE := 64
## Seconds for which a cookie is valid, at least; at most twice as long.
const SLOT_SECONDS := 10.0

## Never sent and never logged.
var _secret := Crypto.new().generate_random_bytes(32)


## Client: the first packet, to be repeated until the cookie arrives.
static func make_hello() -> PackedByteArray:
	var packet := PackedByteArray([Kind.HELLO])
	packet.resize(HELLO_SIZE)
	return packet


## Client: the reply to the server's cookie, to be repeated until the stream arrives. Empty if
## [param packet] is not a cookie.
static func make_join(packet: PackedByteArray) -> PackedByteArray:
	if packet.size() != 1 + COOKIE_SIZE or packet[0] != Kind.COOKIE:
		return PackedByteArray()
	return PackedByteArray([Kind.JOIN]) + packet.slice(1)


## Server: the reply to a hello from an address. Empty if [param packet] is not a hello.
func make_cookie(packet: PackedByteArray, ip: String, port: int, now: float) -> PackedByteArray:
	if packet.size() != HELLO_SIZE or packet[0] != Kind.HELLO:
		return PackedByteArray()
	return PackedByteArray([Kind.COOKIE]) + _hash(ip, port, int(now / SLOT_SECONDS))


## Server: true if a packet is a join with a cookie that was sent to this address recently.
func is_join(packet: PackedByteArray, ip: String, port: int, now: float) -> bool:
	if packet.size() != 1 + COOKIE_SIZE or packet[0] != Kind.JOIN:
		return false
	var slot := int(now / SLOT_SECONDS)
	var crypto := Crypto.new()
	var cookie := packet.slice(1)
	return (
		crypto.constant_time_compare(_hash(ip, port, slot), cookie)
		or crypto.constant_time_compare(_hash(ip, port, slot - 1), cookie)
	)


func _hash(ip: String, port: int, slot: int) -> PackedByteArray:
	var context := HMACContext.new()
	context.start(HashingContext.HASH_SHA256, _secret)
	context.update(("%s %d %d" % [ip, port, slot]).to_utf8_buffer())
	return context.finish().slice(0, COOKIE_SIZE)
