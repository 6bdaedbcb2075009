extends Node
## The server: runs the simulation, validates and applies the input of players, and publishes the
## poses of each tick.

const Connection := preload("connection.gd")
const Options := preload("options.gd")
const PoseLink := preload("replication/pose_link.gd")
const PoseRecorder := preload("measure/pose_recorder.gd")
const Session := preload("session.gd")
const Simulation := preload("world/simulation.gd")
const TruthProbe := preload("measure/truth_probe.gd")

## Seconds between two checks for silent players.
const CHECK_INTERVAL := 0.5
## Frame rate of the main loop: twice the tick rate, so that ticks are on time.
const FRAMES_PER_SECOND := 120
## The server quits this many seconds after the end of the scene, even if players remain.
const MAX_SHUTDOWN := 20.0
## After the end of the scene, the server removes a player after this many seconds of silence,
## because the disconnect message may be lost.
const MAX_FINAL_SILENCE := 2.0

var _options: Options
var _session: Session
## Links by method.
var _links: Dictionary[String, PoseLink]
var _methods: Dictionary[int, String] = {}
var _tolerance := 0.005
var _mode := MultivectorLerp.SEPARATE
var _probe := TruthProbe.new()
var _peer := ENetMultiplayerPeer.new()
var _simulation: Simulation
var _recorder: PoseRecorder
var _rows := PackedFloat32Array()
var _tick := 0
var _first_tick := -1
var _last_tick := -1
## The last tick on the clock of the clients.
var _last_sent_tick := PoseLink.NO_TICK
## Slot of the ball by peer.
var _slots: Dictionary[int, int] = {}
var _names: Dictionary[int, String] = {}
## Time of the last message by peer, in seconds of the local clock.
var _heard_at: Dictionary[int, float] = {}


func _init(options: Options, session: Session, links: Dictionary[String, PoseLink]) -> void:
	_options = options
	_session = session
	_links = links


func _ready() -> void:
	set_physics_process(false)


## Opens the port. Returns an error message, or an empty string.
func open() -> String:
	# No channel count: Godot 4.6 passes it to clients as the incoming bandwidth of the server in
	# bytes per second.
	if _peer.create_server(_options.port, Options.MAX_CLIENTS[_options.scene]) != OK:
		return Connection.get_port_error(_options.port)
	Engine.max_fps = FRAMES_PER_SECOND
	multiplayer.multiplayer_peer = _peer
	multiplayer.peer_connected.connect(_on_peer_connected)
	multiplayer.peer_disconnected.connect(_on_peer_disconnected)
	_session.entered.connect(_on_entered)
	_session.steered.connect(_on_steered)
	_session.kicked.connect(_on_kicked)
	_session.method_requested.connect(_on_method_requested)
	_session.tuning_requested.connect(_on_tuning_requested)
	_session.truth_requested.connect(_on_truth_requested)
	_simulation = Simulation.new(_options.scene, _options.cubes, _options.scripted_motion)
	add_child(_simulation)
	var body_count := _options.cubes + Simulation.SLOTS
	for link: PoseLink in _links.values():
		link.open(body_count)
		link.tune(_tolerance, _mode)
	for id: int in _simulation.get_ids():
		_add_body(id)
	_recorder = PoseRecorder.new(_options.record, body_count)
	_rows.resize(body_count * 12)
	PhysicsServer3D.space_set_active(_simulation.get_world_3d().space, false)
	print(
		"Server on port %d: %d cubes, method %s." % [_options.port, _options.cubes, _options.method]
	)
	set_physics_process(true)
	_begin_if_complete()
	var check_timer := Timer.new()
	check_timer.timeout.connect(_check_players)
	add_child(check_timer)
	check_timer.start(CHECK_INTERVAL)
	return ""


func _exit_tree() -> void:
	if _recorder != null:
		_recorder.close()
	_peer.close()


func _physics_process(delta: float) -> void:
	_tick += 1
	if _first_tick >= 0:
		_simulation.is_calm = (
			_options.calm > 0.0 and _simulation.seconds >= _options.seconds - _options.calm
		)
		_simulation.step(delta)
	var poses := _get_poses()
	for link: PoseLink in _links.values():
		link.publish(poses)
	var sent_tick := _links["motors"].get_sent_tick()
	_send_truth(sent_tick, poses)
	if _first_tick < 0 or _last_tick >= 0:
		return
	if _recorder.is_open():
		for id: int in poses:
			PoseRecorder.set_rows(_rows, id, poses[id])
		_recorder.write(Time.get_unix_time_from_system(), sent_tick, _rows)
	if _options.seconds > 0.0 and _simulation.seconds >= _options.seconds:
		_finish(sent_tick)


func _check_players() -> void:
	var now := Time.get_ticks_msec() * 1e-3
	for peer: int in _slots:
		if _last_tick >= 0:
			_session.finish.rpc_id(peer, _last_sent_tick)
		if (
			now - _heard_at[peer]
			> (Connection.MAX_SILENCE if _last_tick < 0 else MAX_FINAL_SILENCE)
		):
			Connection.expire(_peer.get_peer(peer))


func _get_poses() -> Dictionary[int, Transform3D]:
	var poses: Dictionary[int, Transform3D] = {}
	for id: int in _simulation.get_ids():
		poses[id] = _simulation.get_pose(id)
	return poses


func _begin_if_complete() -> void:
	if _first_tick >= 0 or _slots.size() < _options.clients:
		return
	_first_tick = _tick + 1
	PhysicsServer3D.space_set_active(_simulation.get_world_3d().space, true)
	for peer: int in _slots:
		_session.begin.rpc_id(peer)
	print("The scene begins at tick %d." % _first_tick)


func _finish(sent_tick: float) -> void:
	_last_tick = _tick
	_last_sent_tick = sent_tick
	_recorder.close()
	var counts := _links["motors"].get_counts()
	print(
		"REPORT ",
		(
			JSON
			. stringify(
				{
					"role": "server",
					"seconds": _simulation.seconds,
					"total_packets":
					_peer.host.pop_statistic(ENetConnection.HOST_TOTAL_SENT_PACKETS),
					"rejected": counts["rejected"],
					"unauthorized": counts["unauthorized"],
				}
			)
		)
	)
	get_tree().create_timer(MAX_SHUTDOWN).timeout.connect(get_tree().quit)
	_check_players()
	_quit_if_over()


func _on_peer_connected(peer: int) -> void:
	Connection.prepare(_peer.get_peer(peer))
	_session.welcome.rpc_id(peer, _options.scene, _options.cubes, _options.method, _options.session)


func _on_peer_disconnected(peer: int) -> void:
	if not _slots.has(peer):
		return
	var slot := _slots[peer]
	print("%s has left." % _names[peer])
	_slots.erase(peer)
	_names.erase(peer)
	_heard_at.erase(peer)
	_probe.watchers.erase(peer)
	_links[_methods[peer]].remove_receiver(peer)
	_methods.erase(peer)
	for link: PoseLink in _links.values():
		link.remove_body(_options.cubes + slot)
	_simulation.remove_player(slot)
	_send_roster()
	_quit_if_over()


func _quit_if_over() -> void:
	if _slots.is_empty() and (_options.quit_when_empty or _last_tick >= 0):
		get_tree().quit()


func _on_entered(peer: int, player_name: String) -> void:
	if _slots.has(peer):
		return
	var slot := _simulation.add_player()
	if slot == 0:
		_session.refuse.rpc_id(peer, "The server is full.")
		return
	_slots[peer] = slot
	_names[peer] = Session.get_unique_name(player_name, slot, _names.values())
	_heard_at[peer] = Time.get_ticks_msec() * 1e-3
	_add_body(_options.cubes + slot)
	_session.tune.rpc_id(peer, _tolerance, _mode)
	_set_method(peer, _options.method)
	_send_roster()
	print("%s has joined." % _names[peer])
	if _first_tick >= 0:
		_session.begin.rpc_id(peer)
	_begin_if_complete()


func _add_body(id: int) -> void:
	for link: PoseLink in _links.values():
		link.add_body(id, _simulation.get_pose(id))


func _set_method(peer: int, method: String) -> void:
	if _methods.has(peer):
		_links[_methods[peer]].remove_receiver(peer)
	_methods[peer] = method
	_session.choose_method.rpc_id(peer, method)
	_links[method].add_receiver(peer)


func _on_method_requested(peer: int, method: String) -> void:
	if _slots.has(peer) and _links.has(method) and _methods[peer] != method:
		_set_method(peer, method)


## Tolerance and mode are common to all players, because the motion is sampled once.
func _on_tuning_requested(peer: int, tolerance: float, mode: MultivectorLerp.Mode) -> void:
	if not _slots.has(peer):
		return
	_tolerance = tolerance
	_mode = mode
	for link: PoseLink in _links.values():
		link.tune(tolerance, mode)
	for player: int in _slots:
		_session.tune.rpc_id(player, tolerance, mode)


func _on_truth_requested(peer: int, enabled: bool) -> void:
	_probe.watchers.erase(peer)
	if enabled and _slots.has(peer):
		_probe.watchers.append(peer)


func _send_truth(sent_tick: float, poses: Dictionary[int, Transform3D]) -> void:
	var truth := _probe.observe(sent_tick, poses)
	if truth != null:
		for peer: int in _probe.watchers:
			_session.send_truth.rpc_id(peer, truth.to_bytes())


func _on_steered(peer: int, drive: Vector2, jump: bool) -> void:
	if not _slots.has(peer):
		return
	_heard_at[peer] = Time.get_ticks_msec() * 1e-3
	if _simulation.is_calm:
		return
	var ball := _simulation.get_ball(_slots[peer])
	ball.drive = drive
	ball.wants_jump = jump or ball.wants_jump


func _on_kicked(peer: int, cube: int, direction: Vector3) -> void:
	if not _slots.has(peer) or _simulation.is_calm or cube < 0 or cube >= _options.cubes:
		return
	if _simulation.get_ball(_slots[peer]).take_kick(_simulation.seconds):
		_simulation.kick(cube, direction)


func _send_roster() -> void:
	var roster: Array = []
	if _options.scripted_motion:
		roster.append([0, 1, "Roller"])
	for peer: int in _slots:
		roster.append([_slots[peer], peer, _names[peer]])
	for peer: int in _slots:
		# If several peers leave at once, all are disconnected before the first is reported.
		if _peer.get_peer(peer).get_state() == ENetPacketPeer.STATE_CONNECTED:
			_session.set_roster.rpc_id(peer, roster)
