extends Node
## The server of the scene of avatars: assigns slots, and forwards the motion of the clients. It
## owns no avatar.

const AvatarGroup := preload("avatar_group.gd")
const Connection := preload("../connection.gd")
const LinkMeter := preload("link_meter.gd")
const Options := preload("../options.gd")
const Session := preload("../session.gd")
const TrafficMeter := preload("../measure/traffic_meter.gd")

const FRAMES_PER_SECOND := 120
## Seconds between two messages that the scene has ended.
const FINISH_INTERVAL := 0.5
## The server quits this many seconds after the end of the scene, even if players remain.
const MAX_SHUTDOWN := 20.0

var _options: Options
var _session: Session
var _peer := ENetMultiplayerPeer.new()
var _group := AvatarGroup.new()
var _meter: LinkMeter
## All players, each as [slot, peer, name].
var _roster: Array = []
var _has_begun := false
var _is_over := false


func _init(options: Options, session: Session) -> void:
	_options = options
	_session = session


## Opens the port. Returns an error message, or an empty string.
func open() -> String:
	if _peer.create_server(_options.port, Options.MAX_CLIENTS[Options.AVATARS]) != OK:
		return Connection.get_port_error(_options.port)
	Engine.max_fps = FRAMES_PER_SECOND
	multiplayer.multiplayer_peer = _peer
	_meter = LinkMeter.new(_peer.host, TrafficMeter.new(_peer.host, null))
	multiplayer.peer_connected.connect(_on_peer_connected)
	multiplayer.peer_disconnected.connect(_on_peer_disconnected)
	_session.entered.connect(_on_entered)
	_group.open(_options.relay)
	get_parent().add_child(_group)
	print("Server on port %d: avatars, relay %s." % [_options.port, _options.get_relay_name()])
	_begin_if_complete()
	return ""


func _exit_tree() -> void:
	_peer.close()


func _on_peer_connected(peer: int) -> void:
	Connection.prepare(_peer.get_peer(peer))
	_session.welcome.rpc_id(peer, Options.AVATARS, 0, _options.get_relay_name(), _options.session)


func _on_peer_disconnected(peer: int) -> void:
	for index: int in _roster.size():
		if _roster[index][1] == peer:
			print("%s has left." % _roster[index][2])
			_roster.remove_at(index)
			break
	_send_roster()
	if _roster.is_empty() and (_options.quit_when_empty or _is_over):
		get_tree().quit()


func _on_entered(peer: int, player_name: String) -> void:
	var names: Array[String] = []
	var slot := 1
	for player: Array in _roster:
		if player[1] == peer:
			return
		names.append(player[2])
	while _roster.any(func(player: Array) -> bool: return player[0] == slot):
		slot += 1
	var unique := Session.get_unique_name(player_name, slot, names)
	_roster.append([slot, peer, unique])
	print("%s has joined." % unique)
	_send_roster()
	if _has_begun:
		_session.begin.rpc_id(peer)
	_begin_if_complete()


func _send_roster() -> void:
	_group.show_roster(_roster)
	for peer: int in _get_connected():
		_session.set_roster.rpc_id(peer, _roster)


## If several peers leave at once, all are disconnected before the first is reported.
func _get_connected() -> Array[int]:
	var connected: Array[int] = []
	for player: Array in _roster:
		var peer: int = player[1]
		if _peer.get_peer(peer).get_state() == ENetPacketPeer.STATE_CONNECTED:
			connected.append(peer)
	return connected


func _begin_if_complete() -> void:
	if _has_begun or _roster.size() < _options.clients:
		return
	_has_begun = true
	_meter.begin()
	for peer: int in _get_connected():
		_session.begin.rpc_id(peer)
	print("The scene begins.")
	if _options.seconds > 0.0:
		get_tree().create_timer(_options.seconds).timeout.connect(_finish)


func _finish() -> void:
	_is_over = true
	print("REPORT ", JSON.stringify(_meter.get_report()))
	get_tree().create_timer(MAX_SHUTDOWN).timeout.connect(get_tree().quit)
	var timer := Timer.new()
	timer.timeout.connect(_send_finish)
	add_child(timer)
	timer.start(FINISH_INTERVAL)
	_send_finish()


func _send_finish() -> void:
	for peer: int in _get_connected():
		_session.finish.rpc_id(peer, -1.0)
