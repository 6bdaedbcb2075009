extends "../client_base.gd"
## A client of the scene of avatars: owns one, shows the others.

const AvatarGroup := preload("avatar_group.gd")
const AvatarRecorder := preload("avatar_recorder.gd")
const LinkMeter := preload("link_meter.gd")

## Seconds between two clients that leave at the end of the scene.
const LEAVE_INTERVAL := 0.1

var group := AvatarGroup.new()

var _link_meter: LinkMeter
var _recorder: AvatarRecorder
var _is_over := false


func open() -> String:
	_session.finished.connect(_on_finished)
	get_parent().add_child(group)
	return super()


## Starts the replication when the server has described the scene.
func _on_welcomed(scene: String, _cubes: int, p_method: String, session: String) -> void:
	if _is_accepted or not Options.SCENES.has(scene):
		return
	if not _accept(scene, "", session, scene == Options.AVATARS):
		return
	method = p_method
	_link_meter = LinkMeter.new(_peer.host, meter)
	group.open(method == "on")
	_session.enter.rpc_id(1, _options.player_name)


func _exit_tree() -> void:
	_stop()
	super()


func _process(_delta: float) -> void:
	if _update_connection() and _recorder != null:
		_recorder.record(group)


func _on_roster_changed(p_roster: Array) -> void:
	super(p_roster)
	group.show_roster(roster)


func _on_begun() -> void:
	_link_meter.begin()
	if not _options.record.is_empty():
		_recorder = AvatarRecorder.new(_options.record, _own_id, roster)


## The server repeats this message until the client has left.
func _on_finished(_tick: float) -> void:
	if _is_over:
		return
	_is_over = true
	_stop()
	var report: Dictionary = _link_meter.get_report()
	report["slot"] = get_own_slot()
	report["late"] = group.synchronizer.get_statistics()["late"]
	report["rejected"] = group.synchronizer.get_statistics()["rejected"]
	print("REPORT ", JSON.stringify(report))
	# One after the other: Godot's forwarding fails if a peer leaves while another one does.
	var delay := LEAVE_INTERVAL * get_own_slot()
	get_tree().create_timer(delay).timeout.connect(_close.bind("The scene has ended."))


func _stop() -> void:
	if _recorder != null:
		_recorder.close()
		_recorder = null
