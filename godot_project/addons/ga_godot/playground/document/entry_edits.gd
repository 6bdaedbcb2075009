@tool
extends RefCounted
## The user's edits of entries. Each is one action in the undo history.

const PlaygroundDocument := preload("playground_document.gd")
const NewObjects := preload("new_objects.gd")
const ValueSlider := preload("../entries/value_slider.gd")

## The operations of combine(), in the order of the buttons.
const COMBINATIONS: Array[StringName] = [
	&"join", &"meet", &"intersect", &"project", &"reflect", &"move"
]
const FLATS: Array[StringName] = [&"plane", &"line", &"flat_point"]
const VERSORS: Array[StringName] = [&"rotor", &"translator", &"dilator", &"motor"]

var _document: PlaygroundDocument


func _init(document: PlaygroundDocument) -> void:
	_document = document


## Returns the name of the new entry.
func add_object(kind: StringName, dual: bool) -> String:
	return add(
		"", NewObjects.expression(kind, dual, _document.scene), NewObjects.is_dual(kind, dual), kind
	)


## Returns the name of the new entry. If `entry` is empty, chooses a name for `kind`; an empty
## `kind` stands for the kind of the value.
func add(entry: String, expression: String, ipns := false, kind := &"") -> String:
	if kind.is_empty():
		var value: Multivector = _document.scene.describe_expression(expression)["value"]
		kind = value.classify(ipns)["kind"] if value != null else &""
	if entry.is_empty():
		entry = NewObjects.free_name(kind, _document.scene)
	_document.change(
		"Add %s" % entry,
		func(scene: GAScene) -> void:
			scene.add_entry(entry, expression)
			scene.set_entry_attribute(entry, "ipns", ipns)
	)
	return entry


func set_expression(entry: String, expression: String) -> void:
	_document.change(
		"Edit %s" % entry, func(scene: GAScene) -> void: scene.set_expression(entry, expression)
	)


func rename(from: String, to: String) -> void:
	_document.change(
		"Rename %s to %s" % [from, to], func(scene: GAScene) -> void: scene.rename_entry(from, to)
	)


func move(entry: String, index: int) -> void:
	if index >= 0 and index < _document.scene.get_entry_count():
		_document.change(
			"Move %s" % entry, func(scene: GAScene) -> void: scene.move_entry(entry, index)
		)


func remove(entries: PackedStringArray) -> void:
	_document.change(
		"Delete %s" % ", ".join(entries),
		func(scene: GAScene) -> void:
			for entry in entries:
				scene.remove_entry(entry)
	)


func set_attribute(entry: String, key: String, value: Variant) -> void:
	_document.change(
		"Set %s of %s" % [key, entry],
		func(scene: GAScene) -> void: scene.set_entry_attribute(entry, key, value)
	)


## Keys are the attributes of ValueSlider. Default values are not stored.
func set_slider_range(entry: String, values: Dictionary[String, float]) -> void:
	_document.change(
		"Set Slider Range of %s" % entry,
		func(scene: GAScene) -> void:
			for key in values:
				scene.set_entry_attribute(
					entry, key, values[key] if values[key] != ValueSlider.DEFAULTS[key] else null
				)
	)


## Returns the other entries that would lose their values if `entries` were removed.
func dependents(entries: PackedStringArray) -> PackedStringArray:
	var found: Dictionary[String, bool] = {}
	for entry in entries:
		for dependent in _document.scene.get_dependents(entry):
			found[dependent] = true
	for entry in entries:
		found.erase(entry)
	return PackedStringArray(found.keys())


## The expression that combines two entries; empty if they cannot be combined this way.
func combination(operation: StringName, first: String, second: String) -> String:
	match operation:
		&"join":
			return "join(%s, %s)" % [first, second]
		&"meet":
			return "meet(%s, %s)" % [first, second]
		&"intersect":
			return "meet(%s, %s)" % [_primal(first), _primal(second)]
		&"project":
			return (
				"project_onto(%s, %s)"
				% [_flat(first) if _is_flat(second) else _primal(first), _primal(second)]
			)
		&"reflect":
			return "reflect_in(%s, %s)" % [first, second]
		_:
			if _is_motion(first):
				return "sandwich(%s, %s)" % [first, second]
			return "sandwich(%s, %s)" % [second, first] if _is_motion(second) else ""


## Adds the combination of two entries. Returns the name of the new entry.
func combine(operation: StringName, first: String, second: String) -> String:
	var moved := second if operation == &"move" and _is_motion(first) else first
	var keeps_ipns := operation in [&"reflect", &"move"]
	return add("", combination(operation, first, second), keeps_ipns and _is_ipns(moved))


func _is_motion(entry: String) -> bool:
	var value := _document.scene.get_value(entry)
	return value != null and value.classify()["kind"] in VERSORS


func _is_ipns(entry: String) -> bool:
	return _document.scene.get_entry_attribute(entry, "ipns")


func _is_flat(entry: String) -> bool:
	return _kind(entry) in FLATS


# Points are projected as flat points: the projection of a round point has a radius other than 0.
func _flat(entry: String) -> String:
	return (
		"%s ^ einf" % entry if _kind(entry) == &"point" and not _is_ipns(entry) else _primal(entry)
	)


func _kind(entry: String) -> StringName:
	var value := _document.scene.get_value(entry)
	return value.classify(_is_ipns(entry))["kind"] if value != null else &""


func _primal(entry: String) -> String:
	return "undual(%s)" % entry if _is_ipns(entry) else entry
