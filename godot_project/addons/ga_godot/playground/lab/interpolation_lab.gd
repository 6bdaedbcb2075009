@tool
extends RefCounted
## The model of the interpolation lab: two poses of a document, the parameter t, and display
## settings. LabPanel and LabDrawing show it. It is stored in the document's attributes
## (lab_settings.gd), except for t while the user moves it.

## Emitted when the poses, the settings or the error message change.
signal changed
## Emitted when only t changes.
signal moved

const PlaygroundDocument := preload("../document/playground_document.gd")
const NewObjects := preload("../document/new_objects.gd")
const Modes := preload("interpolation_modes.gd")
const LabPlayback := preload("lab_playback.gd")
const LabPoses := preload("lab_poses.gd")
const LabSettings := preload("lab_settings.gd")

const VALUE := "value"
## The step that t is rounded to in an entry.
const T_STEP := 1e-4

var document: PlaygroundDocument
var poses: LabPoses
## While closed, nothing is computed or drawn.
var is_open := false:
	set = set_open
## The interpolation weight, from 0 to 1. Only an entry can set it outside this range.
var t := 0.5

var _playback := LabPlayback.new()
var _t_before_play := 0.0
var _moved_entry := ""
# The stored settings when they were last read, and their t, which differs from `t` during a drag
# or playback.
var _summary := {}
var _stored_t := NAN


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


## Adds one action to the history.
func set_setting(key: StringName, value: Variant) -> void:
	set_settings("Set Interpolation %s" % String(key).capitalize(), {key: value})


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


## The entry that provides t; empty if none does.
func get_t_entry() -> String:
	var entry: String = get_setting(&"t_entry")
	return entry if _is_number(document.scene, entry) else ""


## All calls of move() between begin_move() and end_move() are one action in the history.
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
		document.scene.set_parameter(entry, VALUE, snappedf(new_t, T_STEP))
	else:
		document.change(
			"Slide %s" % entry,
			func(scene: GAScene) -> void: scene.set_parameter(entry, VALUE, snappedf(new_t, T_STEP))
		)


func end_move() -> void:
	if not _moved_entry.is_empty():
		document.end_gesture("Slide %s" % _moved_entry)
	else:
		set_settings("Slide Interpolation t", {&"t": t})


func is_playing() -> bool:
	return _playback.is_playing


func play() -> void:
	_t_before_play = t
	var repeat: String = get_setting(&"repeat")
	_playback.start(t, repeat)
	moved.emit()


## If t is an entry, adds the playback as one action to the history.
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
		# The playback has ended.
		_playback.is_playing = true
		move(next)
		stop()


## The pose at t as a motor; null without poses.
func get_pose(mode: MultivectorLerp.Mode) -> Multivector:
	return (
		MultivectorLerp.interpolate(poses.from, poses.to, t, mode) if poses.is_complete() else null
	)


## The largest deviation between two modes, see MultivectorLerp.measure_deviation().
func measure(first: MultivectorLerp.Mode, second: MultivectorLerp.Mode) -> Dictionary:
	var lever_arm: float = get_setting(&"lever_arm")
	return MultivectorLerp.measure_deviation(poses.from, poses.to, first, second, lever_arm)


## Adds the interpolation as an entry, and t as a second entry with a slider, which provides the
## lab's t from then on. Returns the name of the first entry, or an empty string without poses.
func add_entry(mode: MultivectorLerp.Mode) -> String:
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
		"Add Interpolation of %s and %s" % [from, to],
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
	_stored_t = NAN
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
	var stored_t: float = get_setting(&"t")
	if not _follow_t_entry() and get_t_entry().is_empty() and stored_t != _stored_t:
		t = stored_t
	_stored_t = stored_t
	var from: String = get_setting(&"from")
	var to: String = get_setting(&"to")
	poses.choose(from, to)


# Reads t from its entry. Returns whether it changed.
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
