extends "motion.gd"
## The server disappears or is out of reach. A client that has lost it connects again. `timeout`:
## milliseconds of silence after which ENet disconnects a peer.

## ENet's limit for 2 to the power of the number of retransmissions of a packet.
const MAX_BACKOFF := 512

var _begins := 0


func _begin() -> void:
	_begins += 1
	recorder.mark("begin %d" % _begins)


func _connect_peer() -> void:
	super._connect_peer()
	if is_server:
		multiplayer.peer_connected.connect(_limit_silence)
	else:
		multiplayer.connection_failed.connect(_connect_again)


func _on_connected() -> void:
	_limit_silence(1)
	super._on_connected()


func _on_disconnected() -> void:
	recorder.mark("lost")
	_connect_again()


func _connect_again() -> void:
	_enet = ENetMultiplayerPeer.new()
	var error := _enet.create_client("127.0.0.1", int(arguments["port"]))
	if error != OK:
		printerr("ERROR: cannot connect again: %s." % error_string(error))
	multiplayer.multiplayer_peer = _enet


func _limit_silence(peer: int) -> void:
	var milliseconds := int(number("timeout"))
	_enet.get_peer(peer).set_timeout(MAX_BACKOFF, milliseconds, 2 * milliseconds)
