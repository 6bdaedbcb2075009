extends SceneTree
## In an exported game: opens the playground and presses a button of its panel, then an example.

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
	var words := panel.find_child("Words", true, false) as Label
	print("[probe] words %s" % words.text)
	_open_last_example(panel)
	scene = document.get(&"scene")
	print("[probe] example %s" % scene.get_scene_attribute("title"))
	print("[probe] done")
	quit()


func _open_last_example(panel: Control) -> void:
	var examples := panel.find_child("Examples", true, false) as PopupMenu
	examples.id_pressed.emit(examples.get_item_id(examples.item_count - 1))
	# Instead of what was added, which is not saved.
	var question := panel.find_child("Question", true, false) as ConfirmationDialog
	if question.visible:
		question.get_ok_button().pressed.emit()


func _click(control: Control) -> void:
	for pressed: bool in [true, false]:
		var event := InputEventMouseButton.new()
		event.button_index = MOUSE_BUTTON_LEFT
		event.pressed = pressed
		event.position = control.get_global_transform_with_canvas() * (control.size / 2.0)
		event.global_position = event.position
		root.push_input(event, true)
