@tool
@abstract
extends RefCounted
## The base of all chapters: access to the dock, waiting, and expectations.

const Hands := preload("res://tests/framework/hands.gd")
const FoldPanel := preload("res://addons/ga_godot/playground/panel/fold_panel.gd")

const SETTLING_FRAMES := 6

var plugin: EditorPlugin
## The number of expectations.
var expectations := 0

var _dock: EditorDock


func _init(p_plugin: EditorPlugin) -> void:
	plugin = p_plugin


## Runs the chapter.
@abstract func run() -> void


func expect(got: Variant, wanted: Variant, what: String) -> void:
	expectations += 1
	if got != wanted:
		print("[probe] FAIL %s: %s, expected %s" % [what, got, wanted])


func expect_true(is_so: bool, what: String) -> void:
	expect(is_so, true, what)


## Waits until the last input has taken effect.
func settle(frames := SETTLING_FRAMES) -> void:
	for frame in frames:
		await plugin.get_tree().process_frame


## Null while the plugin is disabled.
func dock() -> EditorDock:
	# Cached, as the editor has thousands of controls.
	if not is_instance_valid(_dock):
		var found := plugin.get_tree().root.find_children("GAPlayground", "EditorDock", true, false)
		_dock = found[0] if not found.is_empty() else null
	return _dock


func part(path: String) -> Control:
	return dock().get_node("Panel/" + path)


func window() -> Window:
	return dock().get_window()


func line() -> LineEdit:
	return part("Typing/Line")


func typed_words() -> Label:
	return part("Typing/Message")


func file_menu() -> MenuButton:
	return dock().find_child("File", true, false)


func document() -> RefCounted:
	return dock().get(&"document")


func scene() -> GAScene:
	return document().get(&"scene")


func names() -> Array:
	return Array(scene().get_names())


func file_name() -> Label:
	return dock().find_child("FileName", true, false)


func row(entry: String) -> Control:
	return part("Entries").call(&"find_row", entry)


func row_part(entry: String, name: String) -> Control:
	return row(entry).find_child(name, true, false) if row(entry) != null else null


func words_of(entry: String) -> String:
	return (row_part(entry, "Message") as Label).text


func coefficients() -> FoldPanel:
	return dock().find_child("Coefficients", true, false)


func number(blade: String) -> EditorSpinSlider:
	return coefficients().find_child(blade, true, false).get_child(0)


func entry_menu() -> PopupMenu:
	return dock().get_node("Panel/EntryMenu")


## Presses a button in a separate window, which receives no injected clicks.
func press(button: BaseButton) -> void:
	expect(button.disabled, false, "the button %s being disabled" % button.name)
	button.pressed.emit()


## Shows a new scene with these entries: names and expressions alternate.
func begin_with(entries: PackedStringArray) -> void:
	var fresh := GAScene.new()
	for index in range(0, entries.size(), 2):
		fresh.add_entry(entries[index], entries[index + 1])
	document().call(&"show_scene", fresh, "")
	dock().make_visible()
	await settle()


## Selects entries in this order by clicks on their rows.
func select(entries: PackedStringArray) -> void:
	for index in entries.size():
		part("Entries").call(&"scroll_to", entries[index])
		await settle()
		Hands.click(row_part(entries[index], "Message"), MOUSE_BUTTON_LEFT, index > 0)


## Chooses an item of an entry's menu, which is a separate window.
func choose_for_entry(entry: String, item: String) -> void:
	part("Entries").call(&"scroll_to", entry)
	await settle(2)
	Hands.click(row_part(entry, "Menu"))
	choose(entry_menu(), item)
	await settle(2)


func choose(menu: PopupMenu, item: String) -> void:
	for index in menu.item_count:
		if menu.get_item_text(index) == item:
			expect(menu.is_item_disabled(index), false, "the item %s being disabled" % item)
			menu.hide()
			menu.id_pressed.emit(menu.get_item_id(index))
			return
	expect(item, "", "an item that is missing")


func choose_in_file_menu(item: String) -> void:
	choose(file_menu().get_popup(), item)
	await settle()


## Chooses an item of the menu of the dock's tab.
func choose_in_tab_menu(item: String) -> void:
	var tabs := dock().get_parent() as TabContainer
	var bar := tabs.get_tab_bar()
	var middle := bar.get_tab_rect(tabs.get_tab_idx_from_control(dock())).get_center()
	Hands.click(bar, MOUSE_BUTTON_RIGHT, false, middle / bar.size)
	await settle()
	for menu in plugin.get_tree().root.find_children("*", "DockContextPopup", true, false):
		for button: Button in menu.find_children("*", "Button", true, false):
			if button.text == item:
				press(button)
	await settle()


## Presses the editor's shortcut, with the focus outside of text fields.
func undo() -> void:
	window().gui_release_focus()
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL)


func redo() -> void:
	window().gui_release_focus()
	Hands.press_key(window(), KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)


func picture() -> Image:
	RenderingServer.render_loop_enabled = true
	await settle()
	RenderingServer.render_loop_enabled = false
	return dock().get_viewport().get_texture().get_image().get_region(
		Rect2i(dock().get_global_rect())
	)


## The value of a user argument; empty if it is not given.
func argument(option: String) -> String:
	for given in OS.get_cmdline_user_args():
		if given.begins_with(option + "="):
			return given.trim_prefix(option + "=")
	return ""
