extends "forwarding_peer.gd"
## A transport over a narrow line: an ENetMultiplayerPeer whose unreliable packets wait until the
## line has carried those before them, or are lost if they would wait for too long.

## Seconds.
const MAX_WAIT := 0.5

var bytes_per_second := 0.0

var _target := 0
## Of the line: [time, target, packet] of each packet that waits.
var _waiting: Array[Array] = []
var _free_at := 0.0


func _init(peer: MultiplayerPeer, rate: float) -> void:
	super(peer)
	bytes_per_second = rate


func _put_packet_script(packet: PackedByteArray) -> Error:
	if _peer.transfer_mode == MultiplayerPeer.TRANSFER_MODE_RELIABLE:
		return super(packet)
	var now := Time.get_ticks_usec() * 1e-6
	var departure := maxf(now, _free_at) + packet.size() / bytes_per_second
	if departure - now <= MAX_WAIT:
		_free_at = departure
		_waiting.append([departure, _target, packet])
	return OK


func _set_target_peer(id: int) -> void:
	_target = id
	super(id)


func _poll() -> void:
	while not _waiting.is_empty() and _waiting[0][0] <= Time.get_ticks_usec() * 1e-6:
		var next: Array = _waiting.pop_front()
		_peer.transfer_mode = MultiplayerPeer.TRANSFER_MODE_UNRELIABLE
		_peer.set_target_peer(next[1] as int)
		_peer.put_packet(next[2] as PackedByteArray)
	super()
