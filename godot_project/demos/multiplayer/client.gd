extends Node
## A client: joins the server, shows what it sends, and tells it what the player wants.

## Why the client is no longer connected, in words for the player.
signal closed(reason: String)
## Emitted when the server has told what it plays; the link is open.
signal opened(scene: String, cubes: int, method: String)

const Connection := preload("connection.gd")
const Impairment := preload("replication/impairment.gd")
const MotorLink := preload("replication/motor_link.gd")
const Options := preload("options.gd")
const PlayerInput := preload("player_input.gd")
const PoseLink := preload("replication/pose_link.gd")
const PoseRecorder := preload("pose_recorder.gd")
const Session := preload("session.gd")
const Simulation := preload("world/simulation.gd")
const TrafficMeter := preload("traffic_meter.gd")

## Seconds to wait for the server's answer.
const CONNECT_SECONDS := 8.0
## Seconds without a byte after which the server is gone; ENet itself may take twice as long to find out.
const SILENCE_SECONDS := 5.0
const LOST := "The server has closed the session or cannot be reached."
const HEADLESS_FRAMES_PER_SECOND := 60

var meter: TrafficMeter
var link: PoseLink
## All players, as [slot, peer, name] each.
var roster: Array = []
var cube_count := 0
var method := ""

var _options: Options
var _session: Session
var _input: PlayerInput
var _peer := ENetMultiplayerPeer.new()
var _recorder: PoseRecorder
var _make_link: Callable
var _heard_at := 0.0
var _heard_bytes := 0
var _begun_at := -1.0
var _ended_at := -1.0
var _poses_at_begin := 0
var _bytes_at_begin := 0
var _packets_at_begin := 0
var _last_tick := -1
var _report_values: Dictionary = {}
var _own_id := 0
var _is_closed := false


## [param make_link] makes the link for a method's name and adds it to the tree.
func _init(options: Options, session: Session, make_link: Callable) -> void:
	_options = options
	_session = session
	_make_link = make_link


## Starts to connect. Returns what is wrong, or an empty text.
func open() -> String:
	if _peer.create_client(_options.address, _options.port, Connection.CHANNELS) != OK:
		return "Cannot connect to %s:%d." % [_options.address, _options.port]
	if DisplayServer.get_name() == "headless":
		Engine.max_fps = HEADLESS_FRAMES_PER_SECOND
	multiplayer.multiplayer_peer = _peer
	meter = TrafficMeter.new(_peer.host)
	multiplayer.connected_to_server.connect(_on_connected)
	multiplayer.connection_failed.connect(_close.bind("No answer from the server at %s:%d." % [
			_options.address, _options.port]))
	multiplayer.server_disconnected.connect(_close.bind(LOST))
	_session.welcomed.connect(_on_welcomed)
	_session.refused.connect(_close)
	_session.roster_changed.connect(_on_roster_changed)
	_session.begun.connect(_on_begun)
	_session.finished.connect(_on_finished)
	get_tree().create_timer(CONNECT_SECONDS).timeout.connect(_on_connect_timeout)
	return ""


## The slot of this client's ball, or -1 before it has one.
func get_own_slot() -> int:
	for player: Array in roster:
		if player[1] == _own_id:
			return player[0]
	return -1


## The input, for the view to tell it where the camera looks.
func get_input() -> PlayerInput:
	return _input


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
	if link == null:
		return
	if meter.bytes != _heard_bytes:
		_heard_bytes = meter.bytes
		_heard_at = local
	elif local - _heard_at > SILENCE_SECONDS:
		_close(LOST)
		return
	link.advance(local, _recorder)
	if _last_tick >= 0 and (link.get_shown_tick() >= _last_tick):
		_report()
		_close("The scene is over.")


func _on_connected() -> void:
	_own_id = multiplayer.get_unique_id()
	Connection.prepare(_peer.get_peer(1))


func _on_connect_timeout() -> void:
	if cube_count == 0 and not _is_closed:
		_close("No answer from the server at %s:%d." % [_options.address, _options.port])


func _on_welcomed(scene: String, cubes: int, p_method: String) -> void:
	if link != null or cubes < 1 or not Options.METHODS.has(p_method) or not Options.SCENES.has(scene):
		return
	cube_count = cubes
	method = p_method
	link = _make_link.call(method)
	link.open_receiver(cubes + Simulation.SLOTS, cubes)
	var motors := link as MotorLink
	if motors != null and _options.loss + _options.jitter > 0.0:
		motors.impairment = Impairment.new(_options.loss, _options.jitter, _options.seed_value)
	_recorder = PoseRecorder.new(_options.record, cubes + Simulation.SLOTS)
	_input = PlayerInput.new(_session, _options.autopilot)
	add_child(_input)
	opened.emit(scene, cubes, method)
	_session.enter.rpc_id(1, _options.player_name)


func _on_roster_changed(p_roster: Array) -> void:
	var present: Array[int] = []
	for player: Array in p_roster:
		present.append(player[0])
	for player: Array in roster:
		var slot: int = player[0]
		if not present.has(slot):
			link.forget(cube_count + slot)
	roster = p_roster


func _on_begun() -> void:
	_begun_at = Time.get_ticks_usec() * 1e-6
	_poses_at_begin = link.pose_count
	meter.update()
	_bytes_at_begin = meter.bytes
	_packets_at_begin = meter.packets


func _on_finished(tick: int) -> void:
	_ended_at = Time.get_ticks_usec() * 1e-6
	_last_tick = tick
	meter.update()
	_report_values = {
		"role": "client", "method": method, "seconds": _ended_at - _begun_at, "bytes": meter.bytes - _bytes_at_begin,
		"packets": meter.packets - _packets_at_begin,
		"poses": link.pose_count - _poses_at_begin,
	}


func _report() -> void:
	_report_values.merge(link.get_counts())
	_recorder.close()
	print("REPORT ", JSON.stringify(_report_values))


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
