@tool
extends RefCounted
## What a scene keeps of the lab, as attributes "interpolation/KEY". What is as by default is not kept.

const PREFIX := "interpolation/"
const NO_ENTRY := ""

const DEFAULTS: Dictionary[StringName, Variant] = {
	&"from": NO_ENTRY,  # an entry
	&"to": NO_ENTRY,  # an entry
	&"t": 0.5,  # 0..1
	&"t_entry": NO_ENTRY,  # an entry that is a number: t is its value
	&"linear": true,
	&"screw": true,
	&"separate": true,
	&"ghosts": true,
	&"ghost_count": 9.0,
	&"path": true,
	&"body": "frame",  # or "cube"
	&"lever": 1.0,  # metres
	&"duration": 2.5,  # seconds
	&"repeat": "there and back",  # or "loop", "once"
}
const RANGES: Dictionary[StringName, Array] = {
	&"t": [0.0, 1.0],
	&"ghost_count": [2.0, 60.0],
	&"lever": [0.0, 1000.0],
	&"duration": [0.1, 60.0],
}
const CHOICES: Dictionary[StringName, Array] = {
	&"body": ["frame", "cube"],
	&"repeat": ["there and back", "loop", "once"],
}
## By MultivectorLerp.Mode.
const MODES: Array[StringName] = [&"linear", &"screw", &"separate"]


## What the scene says, or the default if it says nothing that could be.
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


## All that the scene says of the lab, to see whether it is still the same.
static func summary(scene: GAScene) -> Dictionary:
	var all := scene.get_scene_attributes()
	for key: String in all.keys():
		if not key.begins_with(PREFIX):
			all.erase(key)
	return all
