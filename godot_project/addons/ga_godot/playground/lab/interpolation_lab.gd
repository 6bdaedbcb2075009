@tool
extends RefCounted
## Two poses of a document and the ways between them: which entries, at which t, and what is shown of it. Panel and drawing
## show what it says; it lives in the document's attributes (lab_settings.gd), except for t while that is moved.

## The poses, the settings, or what is wrong.
signal changed
## t, and nothing else.
signal moved

const PlaygroundDocument := preload("../document/playground_document.gd")
const NewObjects := preload("../document/new_objects.gd")
const Modes := preload("interpolation_modes.gd")
const LabPlayback := preload("lab_playback.gd")
const LabPoses := preload("lab_poses.gd")
const LabSettings := preload("lab_settings.gd")

const VALUE := "value"
## Of what is written into an entry.
const FINEST := 1e-4

var document: PlaygroundDocument
var poses: LabPoses
## Whether it is wanted at all; without, nothing is computed or drawn.
var is_open := false:
	set = set_open
## Further than 0 to 1 only where an entry gives it.
var t := 0.5

var _playback := LabPlayback.new()
var _t_before_play := 0.0
var _moved_entry := ""
## The settings as they were last read, and t among them: what is slid or played is not there.
var _summary := {}
var _kept_t := NAN


func _init(p_document: PlaygroundDocument) -> void:
	document = p_document
	poses = LabPoses.new(document)
	document.scene_switched.connect(_on_scene_switched)
	document.changed.connect(_on_document_changed)
	poses.changed.connect(_on_poses_changed)
	_read_settings()


func set_open(open: bool) -> void:
	if open == is_open:
		return
	is_open = open
	if not open:
		stop()
	poses.set_watching(open)
	_read_settings()
	changed.emit()


func get_setting(key: StringName) -> Variant:
	return LabSettings.read(document.scene, key)


## One step of the history.
func set_setting(key: StringName, value: Variant) -> void:
	set_settings("Set %s of the interpolation" % String(key).replace("_", " "), {key: value})


func set_settings(title: String, settings: Dictionary[StringName, Variant]) -> void:
	document.change(
		title,
		func(scene: GAScene) -> void:
			for key in settings:
				LabSettings.write(scene, key, settings[key])
	)


func choose(from: String, to: String) -> void:
	set_settings("Interpolate from %s to %s" % [from, to], {&"from": from, &"to": to})


func shows_mode(mode: MultivectorLerp.Mode) -> bool:
	return get_setting(LabSettings.MODES[mode])


## The entry that t is the value of; empty if none is.
func get_t_entry() -> String:
	var entry: String = get_setting(&"t_entry")
	return entry if _is_number(document.scene, entry) else ""


## Between begin_move() and end_move(), move() is one step of the history.
func begin_move() -> void:
	stop()
	_moved_entry = get_t_entry()
	if not _moved_entry.is_empty():
		document.begin_gesture()


func move(new_t: float) -> void:
	var entry := get_t_entry()
	if entry.is_empty():
		_set_t(new_t)
	elif document.is_in_gesture() or is_playing():
		document.scene.set_parameter(entry, VALUE, snappedf(new_t, FINEST))
	else:
		document.change(
			"Slide %s" % entry,
			func(scene: GAScene) -> void: scene.set_parameter(entry, VALUE, snappedf(new_t, FINEST))
		)


func end_move() -> void:
	if not _moved_entry.is_empty():
		document.end_gesture("Slide %s" % _moved_entry)
	else:
		set_settings("Slide t of the interpolation", {&"t": t})


func is_playing() -> bool:
	return _playback.is_playing


func play() -> void:
	_t_before_play = t
	var repeat: String = get_setting(&"repeat")
	_playback.start(t, repeat)
	moved.emit()


## What was played on an entry becomes one step of the history.
func stop() -> void:
	if not is_playing():
		return
	_playback.stop()
	var entry := get_t_entry()
	if not entry.is_empty():
		var last := t
		document.scene.set_parameter(entry, VALUE, _t_before_play)
		document.change(
			"Play %s" % entry, func(scene: GAScene) -> void: scene.set_parameter(entry, VALUE, last)
		)
	moved.emit()


func advance(delta: float) -> void:
	if not is_playing():
		return
	var duration: float = get_setting(&"duration")
	var repeat: String = get_setting(&"repeat")
	var next := _playback.advance(delta, duration, repeat)
	if is_playing():
		move(next)
	else:
		# It has come to its end.
		_playback.is_playing = true
		move(next)
		stop()


## The pose at t as a motor, null without poses.
func get_moment(mode: MultivectorLerp.Mode) -> Multivector:
	return (
		MultivectorLerp.interpolate(poses.from, poses.to, t, mode) if poses.is_complete() else null
	)


## The largest deviation of two modes, as MultivectorLerp.measure_deviation tells it.
func measure(first: MultivectorLerp.Mode, second: MultivectorLerp.Mode) -> Dictionary:
	var lever: float = get_setting(&"lever")
	return MultivectorLerp.measure_deviation(poses.from, poses.to, first, second, lever)


## Makes the interpolation an entry, over an entry t with a slider, which then is the lab's t. Its name; empty without poses.
func keep(mode: MultivectorLerp.Mode) -> String:
	if not poses.is_complete():
		return ""
	stop()
	var from := poses.from_name
	var to := poses.to_name
	var entry := NewObjects.free_name(&"motor", document.scene)
	var t_entry := get_t_entry()
	var is_new_t := t_entry.is_empty()
	if is_new_t:
		t_entry = (
			"t"
			if not document.scene.has_entry("t")
			else NewObjects.free_name(&"translator", document.scene)
		)
	var value := t
	document.change(
		"Keep the interpolation of %s and %s" % [from, to],
		func(scene: GAScene) -> void:
			if is_new_t:
				scene.add_entry(t_entry, String.num(snappedf(value, 0.001)))
			scene.add_entry(entry, "%s(%s, %s, %s)" % [Modes.FUNCTIONS[mode], from, to, t_entry])
			LabSettings.write(scene, &"from", from)
			LabSettings.write(scene, &"to", to)
			LabSettings.write(scene, &"t_entry", t_entry)
	)
	return entry


func _on_scene_switched() -> void:
	_playback.stop()
	_kept_t = NAN
	_read_settings()
	changed.emit()


func _on_document_changed() -> void:
	if _follow_t_entry():
		moved.emit()
	var summary := LabSettings.summary(document.scene)
	if summary != _summary:
		_read_settings()
		changed.emit()


func _on_poses_changed() -> void:
	changed.emit()


func _read_settings() -> void:
	_summary = LabSettings.summary(document.scene)
	var kept_t: float = get_setting(&"t")
	if not _follow_t_entry() and get_t_entry().is_empty() and kept_t != _kept_t:
		t = kept_t
	_kept_t = kept_t
	var from: String = get_setting(&"from")
	var to: String = get_setting(&"to")
	poses.choose(from, to)


# Whether an entry has given another t.
func _follow_t_entry() -> bool:
	var entry := get_t_entry()
	if entry.is_empty():
		return false
	var number: float = document.scene.get_parameters(entry)[VALUE]
	var is_other := number != t
	t = number
	return is_other


func _set_t(new_t: float) -> void:
	if new_t != t:
		t = new_t
		moved.emit()


static func _is_number(scene: GAScene, entry: String) -> bool:
	return (
		not entry.is_empty() and scene.has_entry(entry) and scene.get_parameters(entry).has(VALUE)
	)
