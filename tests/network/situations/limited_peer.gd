extends "res://tests/framework/forwarding_peer.gd"
## A transport with small packets: an ENetMultiplayerPeer that refuses packets of more than `limit`
## bytes.

var limit := 0
var refused := 0
var largest := 0


func _init(peer: MultiplayerPeer, packet_limit: int) -> void:
	super(peer)
	limit = packet_limit


func _put_packet_script(packet: PackedByteArray) -> Error:
	largest = maxi(largest, packet.size())
	if packet.size() > limit:
		refused += 1
		return ERR_OUT_OF_MEMORY
	return super(packet)


func _get_max_packet_size() -> int:
	return limit
