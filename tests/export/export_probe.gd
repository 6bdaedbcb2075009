extends Node
## An autoload of the exported demos: with the argument --probe it opens the playground, presses a
## button of its panel and opens an example.

const DEMO := "res://demos/playground/playground.tscn"
const SETTLING_FRAMES := 4


func _ready() -> void:
	if "--probe" in OS.get_cmdline_user_args():
		_open.call_deferred()


func _open() -> void:
	var packed: PackedScene = load(DEMO)
	var demo := packed.instantiate()
	demo.set(&"state_path", "")
	get_tree().root.add_child(demo)
	var panel: Control = demo.get(&"panel")
	var document: RefCounted = panel.get(&"document")
	document.call(&"show_scene", GAScene.new(), "")
	await _settle()
	_click(panel.get_node(^"Objects/point") as Control)
	await _settle()
	var scene: GAScene = document.get(&"scene")
	print("[probe] entries %s" % ", ".join(scene.get_names()))
	var words := panel.find_child("Message", true, false) as Label
	print("[probe] words %s" % words.text)
	var examples := panel.find_child("Examples", true, false) as PopupMenu
	examples.id_pressed.emit(0)
	await get_tree().process_frame
	# Confirms the question about unsaved changes.
	(panel.find_child("Question", true, false) as ConfirmationDialog).confirmed.emit()
	scene = document.get(&"scene")
	print("[probe] example %s" % scene.get_scene_attribute("title"))
	print("[probe] done")
	get_tree().quit()


func _settle() -> void:
	for i in SETTLING_FRAMES:
		await get_tree().process_frame


func _click(control: Control) -> void:
	for pressed: bool in [true, false]:
		var event := InputEventMouseButton.new()
		event.button_index = MOUSE_BUTTON_LEFT
		event.pressed = pressed
		event.position = control.get_global_transform_with_canvas() * (control.size / 2.0)
		event.global_position = event.position
		get_tree().root.push_input(event, true)
