extends SceneTree
## Runs in an exported game: opens the playground, presses a button of its panel and opens an
## example.

const DEMO := "res://demos/playground/playground.tscn"
const SETTLING_FRAMES := 4


func _initialize() -> void:
	var packed: PackedScene = load(DEMO)
	var demo := packed.instantiate()
	demo.set(&"state_path", "")
	root.add_child(demo)
	_use.call_deferred(demo)


func _use(demo: Node) -> void:
	var panel: Control = demo.get(&"panel")
	var document: RefCounted = panel.get(&"document")
	document.call(&"show_scene", GAScene.new(), "")
	for i in SETTLING_FRAMES:
		await process_frame
	_click(panel.get_node(^"Objects/point") as Control)
	for i in SETTLING_FRAMES:
		await process_frame
	var scene: GAScene = document.get(&"scene")
	print("[probe] entries %s" % ", ".join(scene.get_names()))
	var words := panel.find_child("Message", true, false) as Label
	print("[probe] words %s" % words.text)
	var examples := panel.find_child("Examples", true, false) as PopupMenu
	examples.id_pressed.emit(0)
	await process_frame
	# Confirms the question about unsaved changes.
	(panel.find_child("Question", true, false) as ConfirmationDialog).confirmed.emit()
	scene = document.get(&"scene")
	print("[probe] example %s" % scene.get_scene_attribute("title"))
	print("[probe] done")
	quit()


func _click(control: Control) -> void:
	for pressed: bool in [true, false]:
		var event := InputEventMouseButton.new()
		event.button_index = MOUSE_BUTTON_LEFT
		event.pressed = pressed
		event.position = control.get_global_transform_with_canvas() * (control.size / 2.0)
		event.global_position = event.position
		root.push_input(event, true)
