extends MultiplayerPeerExtension
## A transport over a narrow line: an ENetMultiplayerPeer whose unreliable packets wait until the
## line has carried those before them, or are lost if they would wait for too long.

## Seconds.
const MAX_WAIT := 0.5

var bytes_per_second := 0.0

var _peer: MultiplayerPeer
var _target := 0
## Of the line: [time, target, packet] of each packet that waits.
var _waiting: Array[Array] = []
var _free_at := 0.0


func _init(peer: MultiplayerPeer, rate: float) -> void:
	_peer = peer
	bytes_per_second = rate
	_peer.peer_connected.connect(_on_peer_connected)
	_peer.peer_disconnected.connect(_on_peer_disconnected)


func _put_packet_script(packet: PackedByteArray) -> Error:
	if _peer.transfer_mode == MultiplayerPeer.TRANSFER_MODE_RELIABLE:
		return _peer.put_packet(packet)
	var now := Time.get_ticks_usec() * 1e-6
	var departure := maxf(now, _free_at) + packet.size() / bytes_per_second
	if departure - now <= MAX_WAIT:
		_free_at = departure
		_waiting.append([departure, _target, packet])
	return OK


func _get_packet_script() -> PackedByteArray:
	return _peer.get_packet()


func _get_available_packet_count() -> int:
	return _peer.get_available_packet_count()


func _get_max_packet_size() -> int:
	return 1 << 24


func _get_packet_channel() -> int:
	return _peer.get_packet_channel()


func _get_packet_mode() -> MultiplayerPeer.TransferMode:
	return _peer.get_packet_mode()


func _get_packet_peer() -> int:
	return _peer.get_packet_peer()


func _set_target_peer(id: int) -> void:
	_target = id
	_peer.set_target_peer(id)


func _set_transfer_channel(channel: int) -> void:
	_peer.transfer_channel = channel


func _get_transfer_channel() -> int:
	return _peer.transfer_channel


func _set_transfer_mode(mode: MultiplayerPeer.TransferMode) -> void:
	_peer.transfer_mode = mode


func _get_transfer_mode() -> MultiplayerPeer.TransferMode:
	return _peer.transfer_mode


func _set_refuse_new_connections(is_enabled: bool) -> void:
	_peer.refuse_new_connections = is_enabled


func _is_refusing_new_connections() -> bool:
	return _peer.refuse_new_connections


func _is_server() -> bool:
	return _peer.get_unique_id() == 1


func _is_server_relay_supported() -> bool:
	return _peer.is_server_relay_supported()


func _get_unique_id() -> int:
	return _peer.get_unique_id()


func _get_connection_status() -> MultiplayerPeer.ConnectionStatus:
	return _peer.get_connection_status()


func _poll() -> void:
	while not _waiting.is_empty() and _waiting[0][0] <= Time.get_ticks_usec() * 1e-6:
		var next: Array = _waiting.pop_front()
		_peer.transfer_mode = MultiplayerPeer.TRANSFER_MODE_UNRELIABLE
		_peer.set_target_peer(next[1] as int)
		_peer.put_packet(next[2] as PackedByteArray)
	_peer.poll()


func _disconnect_peer(id: int, is_forced: bool) -> void:
	_peer.disconnect_peer(id, is_forced)


func _close() -> void:
	_peer.close()


func _on_peer_connected(id: int) -> void:
	peer_connected.emit(id)


func _on_peer_disconnected(id: int) -> void:
	peer_disconnected.emit(id)
