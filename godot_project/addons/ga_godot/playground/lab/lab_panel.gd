@tool
extends FoldableContainer
## "Interpolation": two poses of the document and the three ways between them. Unfolded, they are drawn.

## An entry was made.
signal added(entry: String)

const EntryList := preload("../entries/entry_list.gd")
const PlaygroundHost := preload("../playground_host.gd")
const InterpolationLab := preload("interpolation_lab.gd")
const LabEnds := preload("lab_ends.gd")
const LabModeRow := preload("lab_mode_row.gd")
const LabPlayer := preload("lab_player.gd")
const LabShown := preload("lab_shown.gd")
const Modes := preload("interpolation_modes.gd")

var lab: InterpolationLab

var _column := VBoxContainer.new()
var _below := VBoxContainer.new()
var _ends: LabEnds
var _player: LabPlayer
var _shown: LabShown
var _rows: Array[LabModeRow] = []
var _keep := MenuButton.new()


func _init(p_lab: InterpolationLab, list: EntryList, host: PlaygroundHost) -> void:
	name = "Interpolation"
	title = "Interpolation"
	folded = true
	lab = p_lab
	_ends = LabEnds.new(lab, list)
	_player = LabPlayer.new(lab)
	_shown = LabShown.new(lab, host)
	_column.name = "Column"
	add_child(_column)
	_column.add_child(_ends)
	_below.name = "Below"
	_column.add_child(_below)
	_below.add_child(_player)
	for mode: MultivectorLerp.Mode in [
		MultivectorLerp.LINEAR, MultivectorLerp.SCREW, MultivectorLerp.SEPARATE
	]:
		_rows.append(LabModeRow.new(lab, mode))
		_below.add_child(_rows[-1])
	_below.add_child(_shown)
	_make_keep()
	lab.changed.connect(_refresh)
	lab.moved.connect(_refresh_moment)
	lab.document.scene_switched.connect(_on_scene_switched)
	folding_changed.connect(_on_folding_changed)
	_on_scene_switched()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree():
		_keep.icon = get_theme_icon(&"arrow", &"OptionButton")
		_refresh()


func _process(delta: float) -> void:
	lab.advance(delta)


func _make_keep() -> void:
	_keep.name = "Keep"
	_keep.text = "Keep as entry"
	_keep.icon_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	_keep.tooltip_text = "Adds the pose at t as an entry, and t as a number with a slider: other entries can then refer to it."
	_keep.size_flags_horizontal = Control.SIZE_SHRINK_BEGIN
	for mode in Modes.COUNT:
		_keep.get_popup().add_item(Modes.TITLES[mode], mode)
	_keep.get_popup().id_pressed.connect(_on_keep_pressed)
	_below.add_child(_keep)


func _refresh() -> void:
	set_process(lab.is_playing())
	if folded:
		return
	_ends.refresh()
	_below.visible = lab.poses.is_complete()
	if not _below.visible:
		return
	_player.refresh()
	_shown.refresh()
	for row in _rows:
		row.refresh()


func _refresh_moment() -> void:
	set_process(lab.is_playing())
	if folded or not lab.poses.is_complete():
		return
	_player.refresh_moment()
	for row in _rows:
		row.refresh_moment()


func _on_scene_switched() -> void:
	# A document that was made with it shows it.
	var from: String = lab.get_setting(&"from")
	folded = from.is_empty()
	_on_folding_changed(folded)


func _on_folding_changed(is_folded: bool) -> void:
	lab.is_open = not is_folded
	_refresh()


func _on_keep_pressed(mode: int) -> void:
	added.emit(lab.keep(mode as MultivectorLerp.Mode))
