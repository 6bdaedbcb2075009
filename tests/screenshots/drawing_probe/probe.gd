@tool
extends "step_probe.gd"
## Edits a scene with GANode3D: views it in one and in four viewports, changes a property in the
## inspector, duplicates, deletes, undoes, saves and reopens. The user arguments --one-view=FILE and
## --four-views=FILE save pictures.

const SCENE := "res://probe_drawing.tscn"
const RED := Color(1, 0, 0)
const GREEN := Color(0, 1, 0)
const BLUE := Color(0, 0, 1)
## The minimum number of pixels of one color that counts as drawn. Objects have thousands, or
## hundreds in a quarter of the view.
const MIN_PIXELS := 60

var _narrow := 0


func _init() -> void:
	settling_frames = 10


func get_steps() -> Array[Callable]:
	return [
		_make_scene,
		_open,
		_show_3d,
		_look,
		_widen,
		_check_wide,
		_undo,
		_check_narrow,
		_change_entry,
		_check_entry,
		_select_ball,
		_duplicate,
		_check_duplicate,
		_undo,
		_check_no_duplicate,
		_select_ball,
		_delete,
		_check_deleted,
		_undo,
		_check_undeleted,
		_split,
		_look_everywhere,
		_unsplit,
		_hide_parent,
		_check_hidden,
		_show_parent,
		_save,
		_reload,
		_check_reloaded,
		_end,
	]


func _make_scene() -> void:
	var root := Node3D.new()
	root.name = "Root"
	var document := GAScene.new()
	document.add_entry("a", "point(1.5, 0, 0)")
	document.add_entry("c", "circle(a, e3, 1)")
	_add(root, "Ball", RED).multivector = Multivector.sphere(Vector3(-1.5, 0, 0), 1.0)
	var circle := _add(root, "Circle", GREEN)
	circle.scene = document
	circle.entry = &"c"
	_add(root, "Line", BLUE).multivector = Multivector.line(Vector3(0, -2, 0), Vector3.RIGHT)
	var packed := PackedScene.new()
	_expect(packed.pack(root), OK, "packing the scene")
	_expect(ResourceSaver.save(packed, SCENE), OK, "saving the scene")
	root.free()


func _add(root: Node3D, title: String, color: Color) -> GANode3D:
	var node := GANode3D.new()
	node.name = title
	node.color = color
	root.add_child(node)
	node.owner = root
	return node


func _open() -> void:
	EditorInterface.open_scene_from_path(SCENE)


func _show_3d() -> void:
	EditorInterface.set_main_screen_editor("3D")


func _look() -> void:
	for color: Color in [RED, GREEN, BLUE]:
		_expect_seen(0, color, true, "after opening")
	_narrow = _count(0, BLUE)
	_save_picture("--one-view=")
	EditorInterface.edit_node(_node("Line"))


## Changes the property through its editor in the inspector.
func _widen() -> void:
	var inspector := EditorInterface.get_inspector()
	var editors := inspector.find_children("*", "EditorProperty", true, false).filter(
		func(editor: EditorProperty) -> bool: return editor.get_edited_property() == &"line_width"
	)
	_expect(editors.size(), 1, "editors of line_width in the inspector")
	if not editors.is_empty():
		var editor: EditorProperty = editors[0]
		editor.emit_changed(&"line_width", 8.0)


func _check_wide() -> void:
	_expect(_node("Line").line_width, 8.0, "line_width from the inspector")
	_expect(
		_count(0, BLUE) > 2 * _narrow,
		true,
		"a wider line has more pixels: %d, before %d" % [_count(0, BLUE), _narrow]
	)


func _undo() -> void:
	Hands.press_key(EditorInterface.get_base_control().get_viewport(), KEY_Z, KEY_MASK_CTRL)


func _check_narrow() -> void:
	_expect(_node("Line").line_width, 2.0, "line_width after undo")
	_expect(_count(0, BLUE), _narrow, "pixels of the line after undo")


func _change_entry() -> void:
	_node("Circle").scene.set_expression("a", "point(1000, 0, 0)")


func _check_entry() -> void:
	_expect_seen(0, GREEN, false, "after the entry's move out of the view")
	_node("Circle").scene.set_expression("a", "point(1.5, 0, 0)")


func _select_ball() -> void:
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(_node("Ball"))


func _duplicate() -> void:
	_expect_seen(0, GREEN, true, "after the entry's move back")
	Hands.press_key(EditorInterface.get_base_control().get_viewport(), KEY_D, KEY_MASK_CTRL)


func _check_duplicate() -> void:
	var copy := _node("Ball2")
	_expect(copy != null, true, "the duplicate is there")
	if copy != null:
		_expect(copy.describe(), _node("Ball").describe(), "what the duplicate draws")


func _check_no_duplicate() -> void:
	_expect(_node("Ball2") == null, true, "no node: the duplicate after undo")
	_expect_seen(0, RED, true, "after undo of the duplicate")


func _delete() -> void:
	Hands.press_key(EditorInterface.get_base_control().get_viewport(), KEY_DELETE, KEY_MASK_SHIFT)


func _check_deleted() -> void:
	_expect(_node("Ball") == null, true, "no node: the ball after deleting")
	_expect_seen(0, RED, false, "after deleting")
	_expect_seen(0, BLUE, true, "what was not deleted")


func _check_undeleted() -> void:
	_expect(_node("Ball") != null, true, "the ball after undo of deleting")
	_expect_seen(0, RED, true, "after undo of deleting")


func _split() -> void:
	_focus_view()
	Hands.press_key(EditorInterface.get_base_control().get_viewport(), KEY_4, KEY_MASK_CTRL)


func _look_everywhere() -> void:
	for view in 4:
		for color: Color in [RED, GREEN, BLUE]:
			_expect_seen(view, color, true, "in view %d of four" % view)
	_save_picture("--four-views=")


func _unsplit() -> void:
	_focus_view()
	Hands.press_key(EditorInterface.get_base_control().get_viewport(), KEY_1, KEY_MASK_CTRL)


func _hide_parent() -> void:
	(EditorInterface.get_edited_scene_root() as Node3D).hide()


func _check_hidden() -> void:
	for color: Color in [RED, GREEN, BLUE]:
		_expect_seen(0, color, false, "under a hidden parent")


func _show_parent() -> void:
	(EditorInterface.get_edited_scene_root() as Node3D).show()
	_node("Ball").color = GREEN


func _save() -> void:
	_expect_seen(0, RED, false, "after another color")
	_expect(EditorInterface.save_scene(), OK, "saving")


func _reload() -> void:
	EditorInterface.reload_scene_from_path(SCENE)


func _check_reloaded() -> void:
	_expect(
		_node("Ball").describe(),
		"sphere, radius 1, center (-1.5, 0, 0)",
		"the ball after saving and loading"
	)
	_expect(_node("Ball").color, GREEN, "its color after saving and loading")
	_expect(
		_node("Circle").describe(),
		"circle, radius 1, center (1.5, 0, 0), normal (0, 0, 1)",
		"the entry after saving and loading"
	)
	_expect_seen(0, GREEN, true, "after saving and loading")
	_expect_seen(0, BLUE, true, "after saving and loading")


## The shortcuts of a view work only while it has the focus.
func _focus_view() -> void:
	var container: Control = EditorInterface.get_editor_viewport_3d(0).get_parent()
	Hands.click(container, MOUSE_BUTTON_LEFT, false, Vector2(0.5, 0.9))


func _node(path: NodePath) -> GANode3D:
	return EditorInterface.get_edited_scene_root().get_node_or_null(path) as GANode3D


func _expect_seen(view: int, color: Color, seen: bool, when: String) -> void:
	var count := _count(view, color)
	_expect(count >= MIN_PIXELS, seen, "%d pixels of %s %s" % [count, color.to_html(false), when])


## Counts the pixels of a view close to a saturated color; the editor's axes are less saturated.
func _count(view: int, color: Color) -> int:
	var picture := EditorInterface.get_editor_viewport_3d(view).get_texture().get_image()
	picture.convert(Image.FORMAT_RGB8)
	var data := picture.get_data()
	var count := 0
	for i in range(0, data.size(), 3):
		var distance := maxf(
			absf(data[i] / 255.0 - color.r),
			maxf(absf(data[i + 1] / 255.0 - color.g), absf(data[i + 2] / 255.0 - color.b))
		)
		if distance < 0.12:
			count += 1
	return count


func _save_picture(option: String) -> void:
	var picture := EditorInterface.get_base_control().get_viewport().get_texture().get_image()
	_expect(picture.save_png(_option(option)), OK, "saving a picture")
