extends "res://tests/framework/test_case.gd"
## The base class of tests that use the playground of a running game by mouse and keyboard.

const EntryRow := preload("res://addons/ga_godot/playground/entries/entry_row.gd")
const Hands := preload("res://tests/framework/hands.gd")
const Playground := preload("res://demos/playground/playground.gd")

var _demo: Playground


func _open(state_path := "") -> void:
	var packed: PackedScene = load("res://demos/playground/playground.tscn")
	_demo = packed.instantiate()
	_demo.state_path = state_path
	add_node(_demo)


func _open_empty(state_path := "") -> void:
	await _open_with({}, state_path)


func _open_with(entries: Dictionary[String, String], state_path := "") -> void:
	_open(state_path)
	var scene := GAScene.new()
	for entry in entries:
		scene.add_entry(entry, entries[entry])
	_demo.panel.document.show_scene(scene, "")
	await wait_frames(3)


func _open_slider_range(entry: String) -> ConfirmationDialog:
	var menu := _demo.panel.get_node(^"EntryMenu") as PopupMenu
	Hands.click(_row(entry).find_child("Menu", true, false) as Control)
	var items := range(menu.item_count).map(
		func(index: int) -> String: return menu.get_item_text(index)
	)
	menu.hide()
	menu.id_pressed.emit(menu.get_item_id(items.find("Slider Range...")))
	await wait_frames(2)
	return menu.get_node(^"SliderRange")


func _numbers(first: float) -> PackedStringArray:
	var numbers := PackedStringArray([str(first)])
	for index in 31:
		numbers.append("0")
	return numbers


## Drags between positions in the view.
func _drag_in_view(from: Vector2, to: Vector2) -> void:
	Hands.drag(_view(), from / _view().size, _view(), to / _view().size)


func _part(path: String) -> Control:
	return _demo.panel.get_node(path)


func _view() -> Control:
	return _demo.get_node(^"%View")


func _row(entry: String) -> EntryRow:
	return _demo.panel.list.find_row(entry)


func _scene() -> GAScene:
	return _demo.panel.document.scene


func _names() -> Array:
	return Array(_scene().get_names())


func _window() -> Viewport:
	return _demo.get_viewport()
