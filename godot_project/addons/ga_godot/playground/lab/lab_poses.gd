@tool
extends RefCounted
## The two entries to interpolate between. Follows changes of their values and names, and describes
## problems with them.

## Emitted when a pose, a name, the candidates or a message changes.
signal changed

const PlaygroundDocument := preload("../document/playground_document.gd")
const LabSettings := preload("lab_settings.gd")

const NUMBER := "value"
const TOO_FEW := "Add two motors to interpolate between, such as motor(e1, rotor(e3, deg(90)))."

var from_name := ""
var to_name := ""
## The motors of the entries; null if an entry is not a valid pose.
var from: Multivector
var to: Multivector
## Says what is wrong with the poses and what to do; otherwise empty.
var error := ""
## Reports that a pose was renamed; otherwise empty.
var notice := ""

var _document: PlaygroundDocument
var _scene: GAScene
var _is_watching := false
var _chosen_from := ""
var _chosen_to := ""
# The entries that can be chosen, as a set.
var _candidates: Dictionary[String, bool] = {}
# The indices of both entries, to recognize them after a rename.
var _from_index := -1
var _to_index := -1


func _init(document: PlaygroundDocument) -> void:
	_document = document
	_document.scene_switched.connect(_on_scene_switched)
	_document.changed.connect(_remember_indices)


func set_watching(watching: bool) -> void:
	_is_watching = watching
	_on_scene_switched()


## Chooses the entries of the settings. An empty name stands for the first unused candidate.
func choose(from_entry: String, to_entry: String) -> void:
	if from_entry == _chosen_from and to_entry == _chosen_to:
		return
	_chosen_from = from_entry
	_chosen_to = to_entry
	notice = ""
	if _is_watching:
		_update()


func is_complete() -> bool:
	return from != null and to != null


## The entries that can be chosen, in the order of the document.
func get_candidates() -> PackedStringArray:
	var names := PackedStringArray()
	if not _candidates.is_empty():
		for entry in _document.scene.get_names():
			if _candidates.has(entry):
				names.append(entry)
	return names


func is_candidate(entry: String) -> bool:
	return _candidates.has(entry)


func _on_scene_switched() -> void:
	if _scene != null:
		_scene.entries_changed.disconnect(_on_entries_changed)
	_scene = _document.scene if _is_watching else null
	_candidates.clear()
	notice = ""
	from = null
	to = null
	if _scene != null:
		_scene.entries_changed.connect(_on_entries_changed)
		_update_candidates(_scene.get_names())
		_update()


func _on_entries_changed(names: PackedStringArray) -> void:
	var has_other_candidates := _update_candidates(names)
	if has_other_candidates or names.has(from_name) or names.has(to_name):
		notice = ""
		if not _follow_names(names):
			_update()
		changed.emit()


# Updates the candidates. Returns whether they changed.
func _update_candidates(names: PackedStringArray) -> bool:
	var has_changed := false
	for entry in names:
		var value := _scene.get_value(entry) if _scene.has_entry(entry) else null
		# Scalars are motors too, but those with a slider are not meant as poses.
		var fits := (
			value != null and value.is_motor() and not _scene.get_parameters(entry).has(NUMBER)
		)
		if fits != _candidates.has(entry):
			has_changed = true
			if fits:
				_candidates[entry] = true
			else:
				_candidates.erase(entry)
	return has_changed


# A missing entry was renamed if a new entry with its value is at its index. Returns whether one
# was renamed.
func _follow_names(names: PackedStringArray) -> bool:
	var new_from := _renamed(_chosen_from, from, _from_index, names)
	var new_to := _renamed(_chosen_to, to, _to_index, names)
	if new_from == _chosen_from and new_to == _chosen_to:
		return false
	var notices := PackedStringArray()
	if new_from != _chosen_from:
		notices.append("%s was renamed to %s." % [_chosen_from, new_from])
	if new_to != _chosen_to and _chosen_to != _chosen_from:
		notices.append("%s was renamed to %s." % [_chosen_to, new_to])
	_chosen_from = new_from
	_chosen_to = new_to
	_update()
	# Not an action in the history: if the rename is undone, this function follows that as well.
	LabSettings.write(_scene, &"from", new_from)
	LabSettings.write(_scene, &"to", new_to)
	notice = " ".join(notices)
	return true


func _renamed(entry: String, value: Multivector, index: int, names: PackedStringArray) -> String:
	if (
		entry.is_empty()
		or value == null
		or _scene.has_entry(entry)
		or index < 0
		or index >= _scene.get_entry_count()
	):
		return entry
	var other := _scene.get_names()[index]
	var is_new := names.has(other) and _scene.get_value(other) != null
	return other if is_new and _scene.get_value(other).coefficients == value.coefficients else entry


func _update() -> void:
	from_name = _chosen_from
	to_name = _chosen_to
	var names := (
		PackedStringArray()
		if not from_name.is_empty() and not to_name.is_empty()
		else get_candidates()
	)
	for entry in names:
		if from_name.is_empty() and entry != to_name:
			from_name = entry
		elif to_name.is_empty() and entry != from_name:
			to_name = entry
	var errors := PackedStringArray()
	from = _motor_of(from_name, errors)
	to = _motor_of(to_name, errors)
	error = TOO_FEW if from_name.is_empty() or to_name.is_empty() else " ".join(errors)
	_remember_indices()


func _motor_of(entry: String, errors: PackedStringArray) -> Multivector:
	if entry.is_empty():
		return null
	if not _scene.has_entry(entry):
		errors.append("%s no longer exists. Choose another entry, or undo." % entry)
		return null
	var value := _scene.get_value(entry)
	if value == null:
		errors.append("%s has no value: %s." % [entry, _scene.get_error(entry).trim_suffix(".")])
		return null
	if not value.is_motor():
		errors.append(
			"%s is not a motor. Choose a product of translators, rotors and dilators." % entry
		)
		return null
	if not value.to_transform().is_finite():
		errors.append("%s is too large to draw. Choose a smaller translation or scale." % entry)
		return null
	return value


func _remember_indices() -> void:
	if _scene != null:
		_from_index = _scene.get_index(from_name) if _scene.has_entry(from_name) else -1
		_to_index = _scene.get_index(to_name) if _scene.has_entry(to_name) else -1
