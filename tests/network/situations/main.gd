extends SceneTree
## Starts one process of a situation: the arguments after `--` are a role, the situation's script in
## this folder, a port, the file to record to, and the configuration as JSON.


func _initialize() -> void:
	var arguments: Dictionary[String, String] = {}
	for argument: String in OS.get_cmdline_user_args():
		arguments[argument.get_slice("=", 0).trim_prefix("--")] = argument.substr(
			argument.find("=") + 1
		)
	var own: Script = get_script()
	var folder := own.resource_path.get_base_dir()
	var script: GDScript = load(folder.path_join(arguments["situation"] + ".gd"))
	if script == null or not script.can_instantiate():
		printerr("ERROR: cannot run the situation %s." % arguments["situation"])
		quit(2)
		return
	var situation: Node = script.new()
	situation.name = &"Situation"
	situation.set(&"arguments", arguments)
	root.add_child(situation)
