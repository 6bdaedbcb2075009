@tool
extends RefCounted
## The settings of the lab, stored as scene attributes "interpolation/KEY" unless they are defaults.

const PREFIX := "interpolation/"
const NO_ENTRY := ""

const DEFAULTS: Dictionary[StringName, Variant] = {
	&"from": NO_ENTRY,  # an entry
	&"to": NO_ENTRY,  # an entry
	&"t": 0.5,  # 0..1
	&"t_entry": NO_ENTRY,  # the entry that provides t, a number
	&"linear": true,
	&"screw": true,
	&"separate": true,
	&"ghosts": true,
	&"ghost_count": 9.0,
	&"path": true,
	&"body": "frame",  # or "cube"
	&"lever_arm": 1.0,  # meters, the lever arm of deviations
	&"duration": 2.5,  # seconds
	&"repeat": "ping-pong",  # or "loop", "once"
}
const RANGES: Dictionary[StringName, Array] = {
	&"t": [0.0, 1.0],
	&"ghost_count": [2.0, 60.0],
	&"lever_arm": [0.0, 1000.0],
	&"duration": [0.1, 60.0],
}
const CHOICES: Dictionary[StringName, Array] = {
	&"body": ["frame", "cube"],
	&"repeat": ["ping-pong", "loop", "once"],
}
## Keys of the visibility of the modes, indexed by MultivectorLerp.Mode.
const MODES: Array[StringName] = [&"linear", &"screw", &"separate"]


## The stored value, or the default if it is missing or invalid.
static func read(scene: GAScene, key: StringName) -> Variant:
	var value: Variant = scene.get_scene_attribute(PREFIX + key)
	var standard: Variant = DEFAULTS[key]
	if typeof(value) != typeof(standard) or (CHOICES.has(key) and not value in CHOICES[key]):
		return standard
	return clamped(key, value as float) if RANGES.has(key) else value


static func clamped(key: StringName, number: float) -> float:
	return clampf(number, RANGES[key][0] as float, RANGES[key][1] as float)


static func write(scene: GAScene, key: StringName, value: Variant) -> void:
	scene.set_scene_attribute(PREFIX + key, null if value == DEFAULTS[key] else value)


## All stored settings, to detect changes.
static func summary(scene: GAScene) -> Dictionary:
	var all := scene.get_scene_attributes()
	for key: String in all.keys():
		if not key.begins_with(PREFIX):
			all.erase(key)
	return all
