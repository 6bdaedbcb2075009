extends "res://tests/framework/test_case.gd"
## What the addon uses where Godot 4.4 lacks a class or method of later versions.

const FoldPanel := preload("res://addons/ga_godot/playground/panel/fold_panel.gd")
const SafeFile := preload("res://addons/ga_godot/playground/document/safe_file.gd")
const SvgTexture := preload("res://addons/ga_godot/playground/theme/svg_texture.gd")

const SVG := '<svg xmlns="http://www.w3.org/2000/svg" width="16" height="8"></svg>'


func test_both_kinds_of_panel_fold() -> void:
	for uses_engine_class: bool in [true, false]:
		var kind := "the engine's class: %s" % uses_engine_class
		var panel := FoldPanel.new(uses_engine_class)
		var foldings: Array[bool] = []
		panel.folding_changed.connect(func(is_folded: bool) -> void: foldings.append(is_folded))
		var content := Control.new()
		content.custom_minimum_size = Vector2(50.0, 100.0)
		panel.add_content(content)
		var extra := Button.new()
		panel.add_title_bar_control(extra)
		panel.title = "Title"
		(Engine.get_main_loop() as SceneTree).root.add_child(panel)
		panel.fold()
		await wait_frames(2)
		expect_true(not content.is_visible_in_tree(), "hidden contents, " + kind)
		expect_true(extra.is_visible_in_tree(), "a visible title bar, " + kind)
		expect_true(panel.get_combined_minimum_size().y < 100.0, "height when folded, " + kind)
		panel.expand()
		panel.expand()
		await wait_frames(2)
		expect_true(content.is_visible_in_tree(), "visible contents, " + kind)
		expect_true(panel.get_combined_minimum_size().y > 100.0, "height when unfolded, " + kind)
		expect_equal(foldings, [true, false], "signals, " + kind)
		panel.free()


func test_a_click_on_the_title_folds() -> void:
	var panel := FoldPanel.new(false)
	(Engine.get_main_loop() as SceneTree).root.add_child(panel)
	panel.title = "Title"
	var button: Button = panel.find_child("Title", true, false)
	expect_equal(button.text, "Title")
	button.pressed.emit()
	expect_true(panel.folded, "folded by a click")
	panel.free()


func test_both_kinds_of_svg_texture_have_the_same_size() -> void:
	for scale: float in [1.0, 2.0]:
		var size := Vector2(16.0, 8.0) * scale
		expect_equal(SvgTexture.make(SVG, scale).get_size(), size, "of the engine's class")
		expect_equal(SvgTexture.make_image(SVG, scale).get_size(), size, "of an image")


func test_the_uid_of_a_file_is_replaced() -> void:
	var path := "user://uid.tres"
	var scene := GAScene.new()
	scene.add_entry("a", "point(1, 2, 3)")
	expect_equal(SafeFile.save_resource(path, scene), OK, "saving")
	var without_uid := FileAccess.get_file_as_string(path)
	for count in 2:
		var uid := ResourceUID.create_id()
		expect_equal(SafeFile.set_uid(path, uid), OK, "setting the UID")
		var attribute := ' uid="%s"' % ResourceUID.id_to_text(uid)
		var text := FileAccess.get_file_as_string(path)
		expect_true(text.get_slice("\n", 0).ends_with(attribute + "]"), "the UID in " + text)
		expect_equal(text.replace(attribute, ""), without_uid, "the rest of the file")
	var loaded: GAScene = ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	expect_equal(loaded.get_expression("a"), "point(1, 2, 3)")
	DirAccess.remove_absolute(path)
