extends Node
## The connection of a client: joins the server, through an impaired network if requested, and
## notices when the server is lost. The scenes extend it.

## Emitted when the connection is closed, with a reason to show to the player.
signal closed(reason: String)
## Emitted when the server has another scene, which needs another client.
signal scene_differs(scene: String)

const Connection := preload("connection.gd")
const LineConditions := preload("network/line_conditions.gd")
const Options := preload("options.gd")
const RunReport := preload("measure/run_report.gd")
const Session := preload("session.gd")
const TrafficMeter := preload("measure/traffic_meter.gd")
const UdpProxy := preload("network/udp_proxy.gd")

## Seconds to wait for the server's reply.
const CONNECT_SECONDS := 8.0
const LOST := "The connection to the server was lost."
## Not a multiple of the server's tick rate, so that frames sample all phases between two ticks.
const HEADLESS_FRAMES_PER_SECOND := 75

var meter: TrafficMeter
## All players, each as [slot, peer, name].
var roster: Array = []
var method := ""
## Network impairments; change them with [method set_conditions].
var conditions: LineConditions

var _options: Options
var _session: Session
var _peer := ENetMultiplayerPeer.new()
## Null if the network is not impaired.
var _proxy: UdpProxy
var _report := RunReport.new()
var _heard_at := 0.0
var _heard_bytes := 0
var _own_id := 0
## Whether the server has described its scene.
var _is_accepted := false
var _is_closed := false


func _init(options: Options, session: Session) -> void:
	_options = options
	_session = session
	conditions = options.conditions


## Starts to connect. Returns an error message, or an empty string.
func open() -> String:
	var is_headless := DisplayServer.get_name() == "headless"
	var address := _options.address
	var port := _options.port
	# With a window the user can impair the network at any time.
	if not is_headless or not conditions.is_perfect():
		_proxy = UdpProxy.new()
		add_child(_proxy)
		if _proxy.open(address, port, _options.seed_value) != OK:
			return "Cannot resolve the address %s." % address
		address = "127.0.0.1"
		port = _proxy.get_port()
	if _peer.create_client(address, port) != OK:
		return "Cannot connect to %s:%d." % [_options.address, _options.port]
	if is_headless:
		Engine.max_fps = HEADLESS_FRAMES_PER_SECOND
	multiplayer.multiplayer_peer = _peer
	meter = TrafficMeter.new(_peer.host, _proxy)
	multiplayer.connected_to_server.connect(_on_connected)
	multiplayer.connection_failed.connect(
		_close.bind("The server at %s:%d does not respond." % [_options.address, _options.port])
	)
	multiplayer.server_disconnected.connect(_close.bind(LOST))
	_session.welcomed.connect(_on_welcomed)
	_session.begun.connect(_on_begun)
	_session.refused.connect(_close)
	_session.roster_changed.connect(_on_roster_changed)
	get_tree().create_timer(CONNECT_SECONDS).timeout.connect(_on_connect_timeout)
	return ""


## Address and port of the server.
func get_server() -> String:
	return "%s:%d" % [_options.address, _options.port]


## Slot of this client, or -1 before it has one.
func get_own_slot() -> int:
	for player: Array in roster:
		if player[1] == _own_id:
			return player[0]
	return -1


## Changes the network impairments. Without a window, this has an effect only if the network was
## impaired from the start.
func set_conditions(p_conditions: LineConditions) -> void:
	conditions = p_conditions
	if _proxy != null:
		_proxy.set_conditions(conditions)


func _exit_tree() -> void:
	_peer.close()


## Call it every frame. Returns whether the client takes part in the scene.
func _update_connection() -> bool:
	if _is_closed:
		return false
	var local := Time.get_ticks_usec() * 1e-6
	if _peer.host != null:
		meter.update()
		meter.count_drops()
	if not _is_accepted:
		return false
	if meter.arrived != _heard_bytes:
		_heard_bytes = meter.arrived
		_heard_at = local
	elif local - _heard_at > Connection.MAX_SILENCE:
		_close(LOST)
		return false
	return true


## The server has described its scene.
func _on_welcomed(_scene: String, _cubes: int, _method: String, _session_name: String) -> void:
	assert(false, "_on_welcomed() is not overridden")


## Checks the description of the scene. Returns whether this client takes part in it; if not, closes
## the connection.
func _accept(scene: String, content: String, session: String, is_own_kind: bool) -> bool:
	if not _options.session.is_empty() and session != _options.session:
		_close(
			(
				"Another server is at %s:%d (scene %s%s). Stop it or use another port."
				% [_options.address, _options.port, scene, content]
			)
		)
		return false
	if not is_own_kind:
		_is_closed = true
		scene_differs.emit(scene)
		return false
	print(
		(
			"Joined the server at %s:%d: scene %s%s."
			% [_options.address, _options.port, scene, content]
		)
	)
	_is_accepted = true
	if _options.leave_after > 0.0:
		get_tree().create_timer(_options.leave_after).timeout.connect(
			_close.bind("Left the session.")
		)
	return true


func _on_connected() -> void:
	_own_id = multiplayer.get_unique_id()
	Connection.prepare(_peer.get_peer(1))


func _on_connect_timeout() -> void:
	if not _is_accepted and not _is_closed:
		_close("The server at %s:%d does not respond." % [_options.address, _options.port])


func _on_roster_changed(p_roster: Array) -> void:
	if roster.is_empty():
		# Not earlier, because ENet's handshake doubles its timeout after each loss, up to half a
		# minute at 33% loss.
		set_conditions(conditions)
	roster = p_roster


func _on_begun() -> void:
	_report.begin(meter)


func _close(reason: String) -> void:
	if _is_closed:
		return
	_is_closed = true
	print(reason)
	_stop()
	_peer.close()
	closed.emit(reason)


## The connection is closed: the scene ends.
func _stop() -> void:
	assert(false, "_stop() is not overridden")
