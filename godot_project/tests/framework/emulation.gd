extends RefCounted
## What tests/platforms tells an engine that it runs in an emulator.


static func is_active() -> bool:
	return not OS.get_environment("GA_GODOT_SLOWNESS").is_empty()


## How many times longer something takes than on a real machine.
static func get_slowness() -> float:
	return maxf(1.0, OS.get_environment("GA_GODOT_SLOWNESS").to_float())


## The program to start for another engine: this one, or what runs it in the emulator.
static func get_engine_path() -> String:
	var path := OS.get_environment("GA_GODOT_ENGINE_STARTER")
	return OS.get_executable_path() if path.is_empty() else path
