extends "limited_peer.gd"
## The transport of a peer of another version: changes the version in the packets of
## MotorSynchronizer, in both directions, so that each side sees another version than its own.

## What precedes a packet in SceneMultiplayer.send_bytes, in bytes.
const COMMAND := 1
const OPEN_VERSION := COMMAND + 5
## The version that this peer sees in the packets of others.
const SEEN_SESSION := 3
const SEEN_STREAM := 150

var _is_stream := false
var _version := 0


func _init(peer: MultiplayerPeer, is_stream: bool, version: int) -> void:
	super(peer, 65536)
	_is_stream = is_stream
	_version = version


func _put_packet_script(packet: PackedByteArray) -> Error:
	return super(_change(packet, _version))


func _get_packet_script() -> PackedByteArray:
	return _change(super(), SEEN_STREAM if _is_stream else SEEN_SESSION)


func _change(packet: PackedByteArray, version: int) -> PackedByteArray:
	# src/net/session/envelope.hpp
	if packet.size() < COMMAND + 4 or packet[COMMAND] & 0xf0 != 0x40:
		return packet
	if packet[COMMAND + 1] != 0xa1 or packet[COMMAND + 2] != 0xc6:
		return packet
	var is_open := packet[COMMAND] & 3 == 0
	if not _is_stream:
		packet[COMMAND] = packet[COMMAND] & 0xf3 | version << 2
	elif is_open and packet.size() > OPEN_VERSION:
		packet[OPEN_VERSION] = version
	return packet
