@tool
extends Node3D
## Draws the interpolation lab next to the objects of the document.

const InterpolationLab := preload("interpolation_lab.gd")
const ModePath := preload("mode_path.gd")

var lab: InterpolationLab:
	set = set_lab

var _paths: Array[ModePath] = []


func _init(p_lab: InterpolationLab = null) -> void:
	name = "Interpolation"
	for mode: MultivectorLerp.Mode in [
		MultivectorLerp.LINEAR, MultivectorLerp.SCREW, MultivectorLerp.SEPARATE
	]:
		var path := ModePath.new(mode)
		path.visible = false
		_paths.append(path)
		add_child(path)
	lab = p_lab


func set_lab(new_lab: InterpolationLab) -> void:
	if lab != null:
		lab.changed.disconnect(_draw)
		lab.moved.disconnect(_draw_t)
	lab = new_lab
	if lab != null:
		lab.changed.connect(_draw)
		lab.moved.connect(_draw_t)
		_draw()


## The node that draws a mode.
func get_path_of(mode: MultivectorLerp.Mode) -> ModePath:
	return _paths[mode]


func _draw() -> void:
	var is_shown := lab.is_open and lab.poses.is_complete()
	visible = is_shown
	if not is_shown:
		return
	var body: String = lab.get_setting(&"body")
	var has_ghosts: bool = lab.get_setting(&"ghosts")
	var count: float = lab.get_setting(&"ghost_count")
	var has_path: bool = lab.get_setting(&"path")
	for path in _paths:
		path.visible = lab.shows_mode(path.mode)
		if path.visible:
			path.set_style(StringName(body), roundi(count) if has_ghosts else 0, has_path)
			path.show_poses(lab.poses.from, lab.poses.to)
			path.show_t(lab.t)


func _draw_t() -> void:
	if visible:
		for path in _paths:
			if path.visible:
				path.show_t(lab.t)
