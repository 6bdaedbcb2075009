## Unloads the library and loads it again; nothing may remain. This script must not name a class of
## the library, which would keep it loaded.
extends SceneTree

const EXTENSION: String = "res://sample.gdextension"


func _initialize() -> void:
	var passed: int = 0
	var failed: int = 0
	var loaded: bool = GDExtensionManager.is_extension_loaded(EXTENSION)
	for i: int in 3:
		var values: RefCounted = ClassDB.instantiate("SampleValues")
		var results: Array = [
			values.call("repeat", "a"),
			values.call("is_editor"),
			values.call("type_of", []),
			is_mapped()
		]
		values = null
		var unloaded: bool = (
			GDExtensionManager.unload_extension(EXTENSION) == GDExtensionManager.LOAD_STATUS_OK
		)
		unloaded = unloaded and not ClassDB.class_exists("SampleValues") and not is_mapped()
		for good: bool in [loaded, results == ["a-a", false, "Array", true], unloaded]:
			passed += int(good)
			failed += int(not good)
		# Not the last time: what the engine frees when it quits may still need the library.
		loaded = (
			i == 2
			or GDExtensionManager.load_extension(EXTENSION) == GDExtensionManager.LOAD_STATUS_OK
		)
	if failed > 0:
		print("FAIL res://reload.gd: the library was not unloaded and loaded again")
	print("[bindings] %d passed, %d failed" % [passed, failed])
	quit()


## Whether the library is mapped into this process. Reads line by line, because the length of the
## file is unknown.
func is_mapped() -> bool:
	var maps: FileAccess = FileAccess.open("/proc/self/maps", FileAccess.READ)
	while not maps.eof_reached():
		if maps.get_line().ends_with("/sample.so"):
			return true
	return false
