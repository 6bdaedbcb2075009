extends Control
## The main menu: one card per demo, for mouse and keyboard.

## Emitted with the name of the demo to open.
signal demo_chosen(demo_name: String)

const Demos := preload("res://menu/demos.gd")

const CARD_SIZE := Vector2(520, 84)

@onready var _cards: VBoxContainer = %Cards


func _ready() -> void:
	for demo in Demos.list():
		if ResourceLoader.exists(demo.get_scene_path()):
			_cards.add_child(_make_card(demo))
	if _cards.get_child_count() > 0:
		var first: Button = _cards.get_child(0)
		first.grab_focus()


func _make_card(demo: Demos) -> Button:
	var card := Button.new()
	card.name = demo.title
	card.custom_minimum_size = CARD_SIZE
	card.size_flags_horizontal = Control.SIZE_SHRINK_BEGIN
	card.pressed.connect(demo_chosen.emit.bind(String(demo.name)))
	card.mouse_entered.connect(card.grab_focus)

	var lines := VBoxContainer.new()
	lines.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT, Control.PRESET_MODE_MINSIZE, 18)
	lines.alignment = BoxContainer.ALIGNMENT_CENTER
	lines.mouse_filter = Control.MOUSE_FILTER_IGNORE
	card.add_child(lines)

	lines.add_child(_make_label(demo.title, &"HeadingLabel"))
	lines.add_child(_make_label(demo.description, &"CaptionLabel"))
	return card


func _make_label(text: String, variation: StringName) -> Label:
	var label := Label.new()
	label.text = text
	label.theme_type_variation = variation
	return label
