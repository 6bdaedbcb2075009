extends "pose_link.gd"
## Poses as quantised motors: chosen by [KeySender], carried as one byte array a datagram by
## an unreliable RPC, shown by [KeyReceiver] at a playback delay.

const KeyReceiver := preload("motor_receiver.gd")
const KeySender := preload("motor_sender.gd")

var _sender: KeySender
var _receiver: KeyReceiver
var _receivers: Array[int] = []
var _shown := -1.0
var _mode := MultivectorLerp.LINEAR


func open_sender(_body_count: int) -> void:
	_sender = KeySender.new()


func add_body(id: int, tick: int, pose: Transform3D) -> void:
	_sender.add_body(id, tick, pose)


func remove_body(id: int) -> void:
	_sender.remove_body(id)


func add_receiver(peer: int, tick: int, poses: Dictionary[int, Transform3D]) -> void:
	if _receivers.is_empty():
		_sender.restart(tick, poses)
	for bytes: PackedByteArray in _sender.make_state(tick, poses):
		_take_state.rpc_id(peer, bytes)
	_receivers.append(peer)


func remove_receiver(peer: int) -> void:
	_receivers.erase(peer)


func publish(tick: int, poses: Dictionary[int, Transform3D]) -> void:
	if _receivers.is_empty():
		return
	for id: int in poses:
		_sender.observe(id, tick, poses[id])
	for bytes: PackedByteArray in _sender.flush(tick):
		for peer: int in _receivers:
			_take_keys.rpc_id(peer, bytes)
	pose_count = _sender.sent_poses


func open_receiver(body_count: int, _present_count: int) -> void:
	_receiver = KeyReceiver.new(body_count)
	_receiver.mode = _mode
	_shown = -1.0


func advance(local: float, recorder: PoseRecorder) -> void:
	pose_count = _receiver.received_poses
	if not is_ready():
		return
	var media := _receiver.clock.advance(local)
	if recorder.is_open():
		_record_ticks(media, recorder)
	_receiver.show(media)
	_shown = media


func get_body_count() -> int:
	return _receiver.pool.get_count()


func get_pose(id: int) -> Transform3D:
	return _receiver.pool.get_transform(id)


func show_in(multimesh: MultiMesh) -> void:
	_receiver.pool.apply_to_multimesh(multimesh)


func forget(id: int) -> void:
	_receiver.forget(id)


func is_ready() -> bool:
	return _receiver != null and _receiver.first_tick >= 0


func get_delay_ms(local: float) -> float:
	return _receiver.clock.get_delay_ms(local) if is_ready() else 0.0


func get_shown_tick() -> float:
	return _shown


func tune(tolerance: float, mode: MultivectorLerp.Mode) -> void:
	_mode = mode
	if _sender != null:
		_sender.tune(tolerance, mode)
	if _receiver != null:
		_receiver.mode = mode


func get_counts() -> Dictionary[String, int]:
	return {"late": _receiver.late_poses, "rejected": _receiver.rejected_datagrams}


## Shows and writes down every whole tick between the last picture and this one, each at its own time.
func _record_ticks(media: float, recorder: PoseRecorder) -> void:
	var wall := Time.get_unix_time_from_system()
	var tick := maxi(floori(_shown) + 1, _receiver.first_tick)
	while tick <= media:
		_receiver.show(tick)
		recorder.write(wall - (media - tick) / _receiver.clock.TICK_RATE, tick, _receiver.pool.get_buffer())
		tick += 1


@rpc("authority", "call_remote", "reliable")
func _take_state(bytes: PackedByteArray) -> void:
	_accept(bytes)


@rpc("authority", "call_remote", "unreliable", 1)
func _take_keys(bytes: PackedByteArray) -> void:
	_accept(bytes)


func _accept(bytes: PackedByteArray) -> void:
	if _receiver != null:
		_receiver.accept(bytes, Time.get_ticks_usec() * 1e-6)
