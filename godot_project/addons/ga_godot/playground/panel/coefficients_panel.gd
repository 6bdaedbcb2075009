@tool
extends "fold_panel.gd"
## The 32 coefficients of the selected entry, which can be edited if it depends on no other entry.

const PlaygroundDocument := preload("../document/playground_document.gd")
const EntryList := preload("../entries/entry_list.gd")
const BasisBlades := preload("../document/basis_blades.gd")
const NumberField := preload("number_field.gd")
const PlaygroundHost := preload("../playground_host.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")

const WIDTH := 96.0
const HEIGHT := 170.0
const STEP := 0.001
## Margin to the right of the basis button's arrow, in pixels.
const ARROW_SPACE := 6.0
## Opacity of coefficients that are 0.
const ZERO_ALPHA := 0.7
const FREE := "Drag to change the coefficient, or click to type it."
const DEPENDENT := "Computed from other entries. Edit those instead."
const WITHOUT_VALUE := "Select an entry that has a value."
const PARAMETER := "coefficients"
## An expression with the parameter "coefficients", which can be set to any value.
const ANY_SUM := "1 + e1"

var _document: PlaygroundDocument
var _list: EntryList
var _entry := ""
var _basis := OptionButton.new()
var _scroll := ScrollContainer.new()
var _host: PlaygroundHost
var _fields: Array[NumberField] = []


func _init(document: PlaygroundDocument, list: EntryList, host: PlaygroundHost) -> void:
	super()
	name = "Coefficients"
	title = "Coefficients"
	folded = true
	_document = document
	_list = list
	_host = host
	_basis.name = "Basis"
	_basis.flat = true
	_basis.focus_mode = Control.FOCUS_NONE
	# No margins, so that the title bar is no higher than those of other panels.
	for style: StringName in [&"normal", &"hover", &"pressed", &"hover_pressed", &"disabled"]:
		var box := StyleBoxEmpty.new()
		box.content_margin_right = ARROW_SPACE * PlaygroundStyle.scale()
		_basis.add_theme_stylebox_override(style, box)
	_basis.add_item("e4, e5")
	_basis.add_item("eo, e∞")
	_basis.tooltip_text = "Basis of the coefficients: e4 and e5, or eo (origin) and e∞ (infinity)."
	_basis.item_selected.connect(func(_index: int) -> void: _show_coefficients())
	add_title_bar_control(_basis)
	var scroll := _scroll
	scroll.horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	scroll.custom_minimum_size.y = HEIGHT * PlaygroundStyle.scale()
	add_content(scroll)
	var grades := VBoxContainer.new()
	grades.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	scroll.add_child(grades)
	for grade in BasisBlades.GRADE_TITLES.size():
		grades.add_child(_make_grade(grade))
	_document.changed.connect(_show_coefficients)
	_list.selection_changed.connect(_on_selection_changed)
	folding_changed.connect(func(_is_folded: bool) -> void: _on_folding_changed())


func _make_grade(grade: int) -> Control:
	var column := VBoxContainer.new()
	column.add_theme_constant_override(&"separation", 0)
	var heading := Label.new()
	heading.text = "%s (grade %d)" % [BasisBlades.GRADE_TITLES[grade], grade]
	heading.modulate = Color(1, 1, 1, 0.65)
	heading.theme_type_variation = &"HeaderSmall"
	column.add_child(heading)
	var flow := HFlowContainer.new()
	column.add_child(flow)
	for index in range(BasisBlades.GRADES[grade], BasisBlades.GRADES[grade + 1]):
		flow.add_child(_make_field(index))
	return column


func _make_field(index: int) -> NumberField:
	var field := _host.make_number_field(STEP)
	field.name = BasisBlades.NAMES[index]
	field.custom_minimum_size.x = WIDTH * PlaygroundStyle.scale()
	field.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	field.edited.connect(_on_edited.bind(index))
	field.grabbed.connect(_document.begin_gesture)
	field.ungrabbed.connect(func() -> void: _document.end_gesture(_get_action_title(index)))
	_fields.append(field)
	return field


## Scrolls to the first grade that is not 0.
func _on_selection_changed() -> void:
	var before := _entry
	_show_coefficients()
	if _entry != before:
		_queue_scroll()


func _on_folding_changed() -> void:
	_show_coefficients()
	_queue_scroll()


# Scrolls in the next frame, when the layout is up to date.
func _queue_scroll() -> void:
	if is_inside_tree() and not get_tree().process_frame.is_connected(_scroll_to_grade):
		get_tree().process_frame.connect(_scroll_to_grade, CONNECT_ONE_SHOT)


func _scroll_to_grade() -> void:
	if not is_inside_tree():
		return
	# A panel that was just unfolded takes one more frame.
	await get_tree().process_frame
	for field in _fields:
		if not is_zero_approx(field.get_number()):
			_scroll.scroll_vertical = roundi(
				(field.get_parent().get_parent() as Control).position.y
			)
			return


func _show_coefficients() -> void:
	_entry = _list.selection[-1] if not _list.selection.is_empty() else ""
	var has_entry := _document.scene.has_entry(_entry)
	title = "Coefficients of %s" % _entry if has_entry else "Coefficients"
	if folded:
		return
	var value: Multivector = _document.scene.get_value(_entry) if has_entry else null
	var numbers := PackedFloat64Array()
	numbers.resize(BasisBlades.NAMES.size())
	if value != null:
		numbers = BasisBlades.from_standard(value.coefficients, _is_null_basis())
	var is_free := value != null and _document.scene.get_dependencies(_entry).is_empty()
	for index in _fields.size():
		_fields[index].show_label(BasisBlades.name_of(index, _is_null_basis()))
		_fields[index].set_read_only(not is_free)
		_fields[index].show_number(numbers[index])
		_fields[index].modulate.a = ZERO_ALPHA if is_zero_approx(numbers[index]) else 1.0
		_fields[index].tooltip_text = (
			FREE if is_free else DEPENDENT if value != null else WITHOUT_VALUE
		)


func _on_edited(number: float, index: int) -> void:
	if _document.is_in_gesture():
		_apply(_document.scene, index, number)
	else:
		_document.change(_get_action_title(index), _apply.bind(index, number))


func _apply(scene: GAScene, index: int, number: float) -> void:
	var numbers := BasisBlades.from_standard(scene.get_value(_entry).coefficients, _is_null_basis())
	numbers[index] = number
	if not scene.get_parameters(_entry).has(PARAMETER):
		scene.set_expression(_entry, ANY_SUM)
	scene.set_parameter(_entry, PARAMETER, BasisBlades.to_standard(numbers, _is_null_basis()))


func _is_null_basis() -> bool:
	return _basis.selected == 1


func _get_action_title(index: int) -> String:
	return "Set %s of %s" % [BasisBlades.name_of(index, _is_null_basis()), _entry]
