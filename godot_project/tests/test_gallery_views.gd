extends "res://tests/framework/test_case.gd"
## The description panel, the camera stored in a document, and the picture dialog.

const DescriptionPanel := preload("res://addons/ga_godot/playground/panel/description_panel.gd")
const Gallery := preload("res://addons/ga_godot/playground/document/gallery.gd")
const PictureDialog := preload("res://addons/ga_godot/playground/picture/picture_dialog.gd")
const PictureExport := preload("res://addons/ga_godot/playground/picture/picture_export.gd")
const ViewPoint := preload("res://addons/ga_godot/playground/picture/view_point.gd")

var _panel: DescriptionPanel


func test_the_panel_is_hidden_without_a_text() -> void:
	_open_panel()
	expect_equal(_panel.visible, false, "without a document")
	_panel.scene = GAScene.new()
	expect_equal(_panel.visible, false, "without a text")


func test_the_panel_shows_and_follows_title_and_text() -> void:
	_open_panel()
	var scene := GAScene.new()
	scene.set_scene_attribute("title", "Two spheres")
	_panel.scene = scene
	expect_equal(_panel.visible, true, "with a title")
	expect_equal(_label("Title").text, "Two spheres", "title")
	expect_equal(_label("Text").is_visible_in_tree(), false, "an empty text takes no space")
	scene.set_scene_attribute("description", " They meet in a circle. ")
	expect_equal(_label("Text").text, "They meet in a circle.", "text")
	expect_equal(_label("Text").is_visible_in_tree(), true, "the text is shown")
	scene.set_scene_attribute("title", 3.0)
	expect_equal(_label("Title").text, "", "a title that is not a string")
	_panel.scene = null
	expect_equal(_panel.visible, false, "without a document")


func test_a_closed_panel_stays_closed_until_the_text_changes() -> void:
	_open_panel()
	_panel.scene = Gallery.load_example("three_spheres")
	var button: Button = _panel.find_child("Close", true, false)
	button.pressed.emit()
	expect_equal(_panel.visible, false, "closed")
	_panel.scene.set_parameter("A", "radius", 1.2)
	_panel.scene = Gallery.load_example("three_spheres")
	expect_equal(_panel.visible, false, "the same text")
	_panel.scene = Gallery.load_example("hexlet")
	expect_equal(_panel.visible, true, "another text")


func test_the_camera_is_stored_in_the_document() -> void:
	var scene := GAScene.new()
	expect_equal(ViewPoint.is_stored_in(scene), false, "stored before writing")
	var view := ViewPoint.new()
	view.from = Vector3(1.25, -2.0, 3.5)
	view.to = Vector3(0.5, 0.0, -1.0)
	view.fov = 55.0
	view.write_to(scene)
	expect_equal(ViewPoint.is_stored_in(scene), true, "stored")
	var copy := GAScene.new()
	copy.load_json(scene.to_json())
	var read := ViewPoint.of(copy)
	expect_vector_near(read.from, view.from, 1e-6, "from")
	expect_vector_near(read.to, view.to, 1e-6, "to")
	expect_near(read.fov, 55.0, 1e-6, "angle")
	var camera := Camera3D.new()
	add_node(camera)
	read.apply_to(camera)
	expect_vector_near(
		-camera.global_basis.z, (view.to - view.from).normalized(), 1e-5, "direction"
	)
	expect_vector_near(
		ViewPoint.of_camera(camera, view.from.distance_to(view.to)).to,
		view.to,
		1e-4,
		"target read back from the camera"
	)


func test_a_narrow_view_keeps_the_horizontal_extent() -> void:
	var view := ViewPoint.new()
	expect_near(view.fov_in(Vector2(1600, 900)), view.fov, 1e-4, "16 : 9")
	expect_near(view.fov_in(Vector2(2000, 900)), view.fov, 1e-4, "wide")
	var usual := tan(deg_to_rad(view.fov) / 2.0) * 16.0 / 9.0
	expect_near(
		tan(deg_to_rad(view.fov_in(Vector2(600, 600))) / 2.0),
		usual,
		1e-6,
		"half the width of a square view at 1 m"
	)
	expect_true(view.fov_in(Vector2(0, 600)) <= ViewPoint.MAX_FOV, "view of zero width")


func test_an_invalid_camera_gives_the_default() -> void:
	for text: Variant in ["", "1, 2", "1, 2, x", "1, 2, inf", "1, 2, 3, 4", 7.0, true]:
		var scene := GAScene.new()
		scene.set_scene_attribute(ViewPoint.FROM, text)
		expect_equal(ViewPoint.of(scene).from, ViewPoint.DEFAULT_FROM, "from %s" % text)
	var at_itself := GAScene.new()
	at_itself.set_scene_attribute(ViewPoint.FROM, "1, 2, 3")
	at_itself.set_scene_attribute(ViewPoint.TO, "1, 2, 3")
	expect_true(ViewPoint.of(at_itself).get_transform().is_finite(), "camera at its own target")
	at_itself.set_scene_attribute(ViewPoint.FROM, "1, 9, 3")
	expect_vector_near(
		-ViewPoint.of(at_itself).get_transform().basis.z, Vector3.DOWN, 1e-6, "from straight above"
	)


func test_the_dialog_returns_the_chosen_size_and_background() -> void:
	var dialog := _open_dialog()
	var sizes: OptionButton = dialog.find_child("Size", true, false)
	expect_equal(dialog.chosen_size(), Vector2i(300, 200), "as shown")
	for choice: Array in [
		[PictureDialog.Size.TWICE, Vector2i(600, 400)],
		[PictureDialog.Size.HD, Vector2i(1920, 1080)],
		[PictureDialog.Size.UHD, Vector2i(3840, 2160)],
		[PictureDialog.Size.CUSTOM, Vector2i(300, 200)]
	]:
		sizes.select(choice[0] as int)
		sizes.item_selected.emit(choice[0] as int)
		expect_equal(dialog.chosen_size(), choice[1], "size")
		expect_equal(
			(dialog.find_child("CustomSize", true, false) as Control).visible,
			choice[0] == PictureDialog.Size.CUSTOM,
			"fields for a custom size"
		)
	var backgrounds: OptionButton = dialog.find_child("Background", true, false)
	expect_equal(dialog.chosen_background(), ViewPoint.DEFAULT_BACKGROUND, "background")
	backgrounds.select(PictureDialog.Background.TRANSPARENT)
	expect_equal(dialog.chosen_background(), Color.TRANSPARENT, "background")


func test_invalid_pictures() -> void:
	expect_equal(PictureExport.size_error(Vector2i(1280, 720)), "", "error")
	expect_true(
		PictureExport.size_error(Vector2i(0, 720)).contains("not 0 x 720"),
		PictureExport.size_error(Vector2i(0, 720))
	)
	expect_true(
		PictureExport.size_error(Vector2i(9000, 720)).contains("at most 8192"),
		PictureExport.size_error(Vector2i(9000, 720))
	)
	# These tests run headless.
	var dialog := _open_dialog()
	var message := await dialog.export_picture()
	expect_equal(message, "No picture was drawn: drawing requires a display.", "error")
	var problem: Label = dialog.find_child("Error", true, false)
	expect_equal(problem.text, message, "message in the dialog")
	expect_true(problem.visible and dialog.visible, "the dialog stays open")


func _open_panel() -> void:
	_panel = DescriptionPanel.new()
	add_node(_panel)


func _open_dialog() -> PictureDialog:
	var dialog := PictureDialog.new(FileDialog.new())
	add_node(dialog)
	dialog.ask(Gallery.load_example("three_spheres"), ViewPoint.new(), Vector2i(300, 200))
	return dialog


func _label(title: String) -> Label:
	return _panel.find_child(title, true, false)
