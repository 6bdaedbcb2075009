extends Node
## A client: joins the server, receives poses and sends the input of the player.

## Emitted when the connection is closed, with a reason to show to the player.
signal closed(reason: String)
## Emitted when the server has described the scene and the link is open.
signal opened(scene: String, cubes: int)
## Emitted when the replication method changes.
signal method_changed
## Emitted when the tolerance or the mode changes.
signal tuned

const Connection := preload("connection.gd")
const ErrorGauge := preload("measure/error_gauge.gd")
const LineConditions := preload("network/line_conditions.gd")
const Options := preload("options.gd")
const PlayerInput := preload("player_input.gd")
const PoseLink := preload("replication/pose_link.gd")
const PoseRecorder := preload("measure/pose_recorder.gd")
const RunReport := preload("measure/run_report.gd")
const Session := preload("session.gd")
const Simulation := preload("world/simulation.gd")
const TrafficMeter := preload("measure/traffic_meter.gd")
const Truth := preload("measure/truth.gd")
const UdpProxy := preload("network/udp_proxy.gd")

## Seconds to wait for the server's reply.
const CONNECT_SECONDS := 8.0
const LOST := "The connection to the server was lost."
## Not a multiple of the server's tick rate, so that frames sample all phases between two ticks.
const HEADLESS_FRAMES_PER_SECOND := 75
## Overhead of a ground truth packet in bytes.
const TRUTH_HEADER := 13

var meter: TrafficMeter
var gauge := ErrorGauge.new()
## The link of the current method; null before the server has described the scene.
var link: PoseLink
## All players, each as [slot, peer, name].
var roster: Array = []
var cube_count := 0
var method := ""
## Tolerance in meters and mode, as decided by the server.
var tolerance := 0.005
var mode := MultivectorLerp.SEPARATE
## Network impairments; change them with [method set_conditions].
var conditions: LineConditions

var _options: Options
var _session: Session
var _input: PlayerInput
var _peer := ENetMultiplayerPeer.new()
var _recorder: PoseRecorder
var _links: Dictionary[String, PoseLink]
## Null if the network is not impaired.
var _proxy: UdpProxy
var _report := RunReport.new()
var _heard_at := 0.0
var _heard_bytes := 0
var _is_over := false
var _last_tick := PoseLink.NO_TICK
var _rows := PackedFloat32Array()
var _own_id := 0
var _is_closed := false


func _init(options: Options, session: Session, links: Dictionary[String, PoseLink]) -> void:
	_options = options
	_session = session
	_links = links
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
	_session.refused.connect(_close)
	_session.roster_changed.connect(_on_roster_changed)
	_session.begun.connect(_on_begun)
	_session.finished.connect(_on_finished)
	_session.method_chosen.connect(_on_method_chosen)
	_session.tuned.connect(_on_tuned)
	_session.truth_received.connect(_on_truth_received)
	get_tree().create_timer(CONNECT_SECONDS).timeout.connect(_on_connect_timeout)
	return ""


## Slot of this client's ball, or -1 before it has one.
func get_own_slot() -> int:
	for player: Array in roster:
		if player[1] == _own_id:
			return player[0]
	return -1


## The player's input. The view sets its yaw to that of the camera.
func get_input() -> PlayerInput:
	return _input


## Changes the network impairments. Without a window, this has an effect only if the network was
## impaired from the start.
func set_conditions(p_conditions: LineConditions) -> void:
	conditions = p_conditions
	if _proxy != null:
		_proxy.set_conditions(conditions)


## Requests another replication method.
func request_method(requested: String) -> void:
	_session.request_method.rpc_id(1, requested)


## Requests another tolerance, in meters, and another mode, for all players.
func request_tuning(requested_tolerance: float, requested_mode: MultivectorLerp.Mode) -> void:
	_session.request_tuning.rpc_id(1, requested_tolerance, requested_mode)


## Requests that the server starts or stops sending the ground truth that [member gauge] needs.
func request_truth(requested: bool) -> void:
	_session.request_truth.rpc_id(1, requested)


func _exit_tree() -> void:
	if _recorder != null:
		_recorder.close()
	_peer.close()


func _process(_delta: float) -> void:
	if _is_closed:
		return
	var local := Time.get_ticks_usec() * 1e-6
	if _peer.host != null:
		meter.update()
		meter.count_drops()
	if link == null:
		return
	if meter.arrived != _heard_bytes:
		_heard_bytes = meter.arrived
		_heard_at = local
	elif local - _heard_at > Connection.MAX_SILENCE:
		_close(LOST)
		return
	if not link.is_ready():
		return
	_record()
	gauge.update(link)
	if _is_over and link.get_shown_tick() >= _last_tick:
		_recorder.close()
		_report.print_json(link)
		_close("The scene has ended.")


func _on_connected() -> void:
	_own_id = multiplayer.get_unique_id()
	Connection.prepare(_peer.get_peer(1))


func _on_connect_timeout() -> void:
	if cube_count == 0 and not _is_closed:
		_close("The server at %s:%d does not respond." % [_options.address, _options.port])


func _on_welcomed(scene: String, cubes: int, p_method: String, session: String) -> void:
	if (
		link != null
		or cubes < 1
		or not Options.METHODS.has(p_method)
		or not Options.SCENES.has(scene)
	):
		return
	if not _options.session.is_empty() and session != _options.session:
		_close(
			(
				"Another server is at %s:%d (scene %s, %d cubes). Stop it or use another port."
				% [_options.address, _options.port, scene, cubes]
			)
		)
		return
	print(
		(
			"Joined the server at %s:%d: scene %s, %d cubes."
			% [_options.address, _options.port, scene, cubes]
		)
	)
	cube_count = cubes
	method = p_method
	link = _links[method]
	var body_count := cubes + Simulation.SLOTS
	for each: PoseLink in _links.values():
		each.open(body_count)
	link.begin(cubes)
	_recorder = PoseRecorder.new(_options.record, body_count)
	_rows.resize(body_count * 12)
	if _options.leave_after > 0.0:
		get_tree().create_timer(_options.leave_after).timeout.connect(
			_close.bind("Left the session.")
		)
	_input = PlayerInput.new(_session, _options.autopilot)
	add_child(_input)
	_session.enter.rpc_id(1, _options.player_name)
	opened.emit(scene, cubes)


func _on_method_chosen(chosen: String) -> void:
	if chosen == method or not _links.has(chosen):
		return
	method = chosen
	link.end()
	link = _links[method]
	link.begin(cube_count)
	gauge.clear()
	method_changed.emit()


func _on_roster_changed(p_roster: Array) -> void:
	if roster.is_empty():
		# Not earlier, because ENet's handshake doubles its timeout after each loss, up to half a
		# minute at 33% loss.
		set_conditions(conditions)
	roster = p_roster


func _on_begun() -> void:
	_report.begin(meter)


## The server repeats this message until the client has left.
func _on_finished(tick: float) -> void:
	if _is_over:
		return
	_is_over = true
	# A link without a clock shows the end when the message arrives.
	_last_tick = tick if link.get_shown_tick() >= 0.0 else PoseLink.NO_TICK
	_report.finish(method, meter)


func _record() -> void:
	if _recorder.is_open():
		for id: int in link.bodies.size():
			PoseRecorder.set_rows(_rows, id, link.bodies[id].transform)
		_recorder.write(Time.get_unix_time_from_system(), link.get_shown_tick(), _rows)


func _on_tuned(p_tolerance: float, p_mode: MultivectorLerp.Mode) -> void:
	tolerance = p_tolerance
	mode = p_mode
	for each: PoseLink in _links.values():
		each.tune(tolerance, mode)
	tuned.emit()


func _on_truth_received(bytes: PackedByteArray) -> void:
	meter.discount(bytes.size() + TRUTH_HEADER)
	var truth := Truth.from_bytes(bytes, cube_count + Simulation.SLOTS)
	if truth != null:
		gauge.take(truth, link)


func _close(reason: String) -> void:
	if _is_closed:
		return
	_is_closed = true
	print(reason)
	if _input != null:
		_input.process_mode = Node.PROCESS_MODE_DISABLED
	if _recorder != null:
		_recorder.close()
	_peer.close()
	closed.emit(reason)
