extends "client_base.gd"
## A client of the scenes of cubes: receives poses and sends the input of the player.

## Emitted when the server has described the scene and the link is open.
signal opened(scene: String, cubes: int)
## Emitted when the replication method changes.
signal method_changed
## Emitted when the tolerance or the mode changes.
signal tuned

const ErrorGauge := preload("measure/error_gauge.gd")
const PlayerInput := preload("player_input.gd")
const PoseLink := preload("replication/pose_link.gd")
const PoseRecorder := preload("measure/pose_recorder.gd")
const Simulation := preload("world/simulation.gd")
const Truth := preload("measure/truth.gd")

## Overhead of a ground truth packet in bytes.
const TRUTH_HEADER := 13

var gauge := ErrorGauge.new()
## The link of the current method; null before the server has described the scene.
var link: PoseLink
var cube_count := 0
## Tolerance in meters and mode, as decided by the server.
var tolerance := 0.005
var mode := MultivectorLerp.SEPARATE

var _input: PlayerInput
var _recorder: PoseRecorder
var _links: Dictionary[String, PoseLink]
var _is_over := false
var _last_tick := PoseLink.NO_TICK
var _rows := PackedFloat32Array()


func _init(options: Options, session: Session, links: Dictionary[String, PoseLink]) -> void:
	super(options, session)
	_links = links


func open() -> String:
	_session.finished.connect(_on_finished)
	_session.method_chosen.connect(_on_method_chosen)
	_session.tuned.connect(_on_tuned)
	_session.truth_received.connect(_on_truth_received)
	return super()


## The player's input. The view sets its yaw to that of the camera.
func get_input() -> PlayerInput:
	return _input


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
	super()


func _process(_delta: float) -> void:
	if not _update_connection() or not link.is_ready():
		return
	_record()
	gauge.update(link)
	if _is_over and link.get_shown_tick() >= _last_tick:
		_recorder.close()
		_report.print_json(link.get_counts())
		_close("The scene has ended.")


func _on_welcomed(scene: String, cubes: int, p_method: String, session: String) -> void:
	if link != null or not Options.SCENES.has(scene):
		return
	var content := ", %d cubes" % cubes
	if not _accept(scene, content, session, scene != Options.AVATARS):
		return
	if cubes < 1 or not _links.has(p_method):
		_close("The server runs another version of the demo.")
		return
	cube_count = cubes
	method = p_method
	link = _links[method]
	var body_count := cubes + Simulation.SLOTS
	for each: PoseLink in _links.values():
		each.open(body_count)
	link.begin(cubes)
	_recorder = PoseRecorder.new(_options.record, body_count)
	_rows.resize(body_count * 12)
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


func _stop() -> void:
	if _input != null:
		_input.process_mode = Node.PROCESS_MODE_DISABLED
	if _recorder != null:
		_recorder.close()
