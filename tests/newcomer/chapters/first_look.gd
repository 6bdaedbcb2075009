@tool
extends "../chapter.gd"
## What a newcomer sees at first: the dock, the class help, and a scene without warnings. The user
## argument --pictures=FOLDER is where a picture of the editor is saved.

const MIN_COLORS := 40


func run() -> void:
	expect(EditorInterface.is_plugin_enabled("ga_godot"), true, "the plugin being enabled")
	await _open_scene()
	await _look_at_the_dock()
	await _read_help()


func _open_scene() -> void:
	EditorInterface.open_scene_from_path("res://main.tscn")
	EditorInterface.set_main_screen_editor("3D")
	await settle()
	var synchronizer: MotorSynchronizer = EditorInterface.get_edited_scene_root().get_node(
		^"MotorSynchronizer"
	)
	expect(Array(synchronizer.get_setup_warnings()), [], "warnings of the guide's scene")
	EditorInterface.edit_node(synchronizer)


func _look_at_the_dock() -> void:
	expect_true(dock() != null, "the dock")
	expect_true(_is_in_a_menu("GA Playground"), "the dock in the menu of docks")
	dock().make_visible()
	await settle(30)
	expect_true(dock().is_visible_in_tree(), "the dock being visible")
	var shown := await picture()
	expect_true(_count_colors(shown) >= MIN_COLORS, "%d colors" % _count_colors(shown))
	await save_picture("editor_first_look")


func _is_in_a_menu(text: String) -> bool:
	for menu: PopupMenu in plugin.get_tree().root.find_children("*", "PopupMenu", true, false):
		for item in menu.item_count:
			if menu.get_item_text(item) == text:
				return true
	return false


func _read_help() -> void:
	EditorInterface.get_script_editor().goto_help("class_name:MotorSynchronizer")
	EditorInterface.set_main_screen_editor("Script")
	await settle(30)
	var found := false
	for page in plugin.get_tree().root.find_children("*", "EditorHelp", true, false):
		for text: RichTextLabel in page.find_children("*", "RichTextLabel", true, false):
			found = found or text.get_parsed_text().contains("position_tolerance")
	expect_true(found, "the page of MotorSynchronizer in the help")
	await save_picture("editor_help")
	EditorInterface.set_main_screen_editor("3D")
	await settle()


func save_picture(title: String) -> void:
	RenderingServer.render_loop_enabled = true
	await settle()
	RenderingServer.render_loop_enabled = false
	var shown := plugin.get_viewport().get_texture().get_image()
	var file := argument("--pictures").path_join("%s.png" % title)
	expect(shown.save_png(file), OK, "saving %s" % file)


func _count_colors(shown: Image) -> int:
	var colors: Dictionary[Color, bool] = {}
	for y in range(0, shown.get_height(), 2):
		for x in range(0, shown.get_width(), 2):
			colors[shown.get_pixel(x, y)] = true
	return colors.size()
