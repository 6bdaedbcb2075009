@tool
extends "../panel/fold_panel.gd"
## The panel "Interpolation": two poses of the document and three interpolations between them. The
## interpolations are drawn while the panel is unfolded.

## Emitted when an entry is added.
signal added(entry: String)

const EntryList := preload("../entries/entry_list.gd")
const PlaygroundHost := preload("../playground_host.gd")
const InterpolationLab := preload("interpolation_lab.gd")
const LabEndpoints := preload("lab_endpoints.gd")
const LabModeRow := preload("lab_mode_row.gd")
const LabPlayer := preload("lab_player.gd")
const LabDisplay := preload("lab_display.gd")
const Modes := preload("interpolation_modes.gd")

var lab: InterpolationLab

var _column := VBoxContainer.new()
var _details := VBoxContainer.new()
var _ends: LabEndpoints
var _player: LabPlayer
var _shown: LabDisplay
var _rows: Array[LabModeRow] = []
var _add_entry := MenuButton.new()


func _init(p_lab: InterpolationLab, list: EntryList, host: PlaygroundHost) -> void:
	super()
	name = "Interpolation"
	title = "Interpolation"
	folded = true
	lab = p_lab
	_ends = LabEndpoints.new(lab, list)
	_player = LabPlayer.new(lab)
	_shown = LabDisplay.new(lab, host)
	_column.name = "Column"
	add_content(_column)
	_column.add_child(_ends)
	_details.name = "Details"
	_column.add_child(_details)
	_details.add_child(_player)
	for mode: MultivectorLerp.Mode in [
		MultivectorLerp.LINEAR, MultivectorLerp.SCREW, MultivectorLerp.SEPARATE
	]:
		_rows.append(LabModeRow.new(lab, mode))
		_details.add_child(_rows[-1])
	_details.add_child(_shown)
	_make_add_entry()
	lab.changed.connect(_refresh)
	lab.moved.connect(_refresh_t)
	lab.document.scene_switched.connect(_on_scene_switched)
	folding_changed.connect(_on_folding_changed)
	_on_scene_switched()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree():
		_add_entry.icon = get_theme_icon(&"arrow", &"OptionButton")
		_refresh()


func _process(delta: float) -> void:
	lab.advance(delta)


func _make_add_entry() -> void:
	_add_entry.name = "AddEntry"
	_add_entry.text = "Add as Entry"
	_add_entry.icon_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	_add_entry.tooltip_text = (
		"Add the pose at t as an entry, and t as a number with a slider, so that other entries can"
		+ " depend on them."
	)
	_add_entry.size_flags_horizontal = Control.SIZE_SHRINK_BEGIN
	for mode in Modes.COUNT:
		_add_entry.get_popup().add_item(Modes.TITLES[mode], mode)
	_add_entry.get_popup().id_pressed.connect(_on_mode_chosen)
	_details.add_child(_add_entry)


func _refresh() -> void:
	set_process(lab.is_playing())
	if folded:
		return
	_ends.refresh()
	_details.visible = lab.poses.is_complete()
	if not _details.visible:
		return
	_player.refresh()
	_shown.refresh()
	for row in _rows:
		row.refresh()


func _refresh_t() -> void:
	set_process(lab.is_playing())
	if folded or not lab.poses.is_complete():
		return
	_player.refresh_t()
	for row in _rows:
		row.refresh_t()


func _on_scene_switched() -> void:
	# Unfolds for documents that have settings of the lab.
	var from: String = lab.get_setting(&"from")
	folded = from.is_empty()
	_on_folding_changed(folded)


func _on_folding_changed(is_folded: bool) -> void:
	lab.is_open = not is_folded
	_refresh()


func _on_mode_chosen(mode: int) -> void:
	added.emit(lab.add_entry(mode as MultivectorLerp.Mode))
