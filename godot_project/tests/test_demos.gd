extends "res://tests/framework/test_case.gd"
## The demos open from the menu and the command line, run without errors, and return to the menu.

const Demos := preload("res://menu/demos.gd")
const Main := preload("res://main.gd")
const NetworkBranch := preload("res://tests/framework/network_branch.gd")

const FRAMES := 60


func test_the_menu_lists_every_demo() -> void:
	var menu := _open("res://menu/menu.tscn")
	var titles := PackedStringArray()
	for button: Button in menu.find_children("*", "Button", true, false):
		titles.append(button.name)
	expect_equal(titles, PackedStringArray(["Interpolation", "Multiplayer", "Playground"]))


func test_choosing_a_card_emits_its_demo() -> void:
	var menu := _open("res://menu/menu.tscn")
	var chosen: Array[String] = []
	menu.connect(&"demo_chosen", func(demo_name: String) -> void: chosen.append(demo_name))
	var cards := menu.find_children("*", "Button", true, false)
	expect_true(tree.root.gui_get_focus_owner() == cards[0], "focus of the first card")
	for card: Button in cards:
		card.pressed.emit()
	expect_equal(chosen, ["interpolation", "multiplayer", "playground"] as Array[String])


func test_the_keyboard_chooses_a_demo() -> void:
	var menu := _open("res://menu/menu.tscn")
	var chosen: Array[String] = []
	menu.connect(&"demo_chosen", func(demo_name: String) -> void: chosen.append(demo_name))
	await wait_frames(2)
	_press(KEY_DOWN)
	_press(KEY_ENTER)
	await wait_frames(2)
	expect_equal(chosen, ["multiplayer"] as Array[String])


func test_the_interpolation_demo_runs() -> void:
	var scene := _open("res://demos/interpolation/interpolation.tscn")
	await wait_frames(FRAMES)
	expect_true(scene.is_inside_tree(), "the demo staying open")


## In a separate process, because the demo reads the command line.
func test_the_multiplayer_server_runs() -> void:
	var output: Array = []
	var port := "--port=%d" % NetworkBranch.find_free_port()
	var code := _start(
		["--demo=multiplayer", "--role=server", "--cubes=20", "--seconds=1", port], output
	)
	expect_equal(code, 0, "exit code")
	_expect_clean(output)


func test_an_unknown_demo_is_refused() -> void:
	var output: Array = []
	expect_equal(_start(["--demo=nonsense"], output), 1, "exit code")
	var text: String = output[0]
	expect_true(
		(
			text
			. contains(
				'There is no demo named "nonsense". Available demos: interpolation, multiplayer, playground.'
			)
		),
		'the reason in "%s"' % text
	)


func test_escape_returns_to_the_menu() -> void:
	var main := Main.new()
	# The arguments of this process would run the tests again.
	main.arguments = PackedStringArray()
	add_node(main)
	main.open_demo("interpolation")
	await wait_frames(2)
	expect_equal(_shown_path(main), "res://demos/interpolation/interpolation.tscn")
	_press(KEY_ESCAPE)
	await wait_frames(2)
	expect_equal(_shown_path(main), "res://menu/menu.tscn")


func _open(path: String) -> Node:
	var packed: PackedScene = load(path)
	var scene := packed.instantiate()
	add_node(scene)
	return scene


func _shown_path(main: Node) -> String:
	return main.get_child(main.get_child_count() - 1).scene_file_path


func _press(key: Key) -> void:
	for pressed: bool in [true, false]:
		var event := InputEventKey.new()
		event.keycode = key
		event.pressed = pressed
		Input.parse_input_event(event)


## Runs the project in a headless process with these arguments after `--`. Returns the exit code.
func _start(arguments: PackedStringArray, output: Array) -> int:
	var all := PackedStringArray(
		["--headless", "--path", ProjectSettings.globalize_path("res://"), "--"]
	)
	all.append_array(arguments)
	return OS.execute(Emulation.get_engine_path(), all, output, true)


func _expect_clean(output: Array) -> void:
	var text: String = output[0]
	for mark: String in ["ERROR", "leaked at exit", "still in use at exit"]:
		expect_true(not text.contains(mark), 'absence of "%s" in:\n%s' % [mark, text])
