## Runs each check_ method of these files against the sample extension and prints the numbers of
## passed and failed checks.
extends SceneTree

const FILES: Array[String] = [
	"res://check_values.gd",
	"res://check_objects.gd",
	"res://check_calls.gd",
	"res://check_nodes.gd",
	"res://check_network.gd",
	"res://check_classes.gd"
]


func _initialize() -> void:
	run.call_deferred()


func run() -> void:
	var passed: int = 0
	var failed: int = 0
	for path: String in FILES:
		var script: GDScript = load(path)
		for method: Dictionary in script.get_script_method_list():
			var method_name: String = method["name"]
			if not method_name.begins_with("check_"):
				continue
			var checks: Checks = script.new()
			checks.tree = self
			await checks.call(method_name)
			passed += checks.passed
			failed += checks.failed
			if checks.passed + checks.failed == 0:
				failed += 1
				print("FAIL %s: did not run to its end" % method_name)
	print("[bindings] %d passed, %d failed" % [passed, failed])
	quit(1 if failed > 0 else 0)
