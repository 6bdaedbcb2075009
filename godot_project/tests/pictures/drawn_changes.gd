extends Control
## Objects in two worlds side by side, created in their final state or brought there by hiding,
## freeing, and changes of value and world. Both must look the same.

const DrawnChanges := preload("res://tests/pictures/drawn_changes.gd")

const COLORS: Array[Color] = [
	Color(0.36, 0.72, 1.0), Color(1.0, 0.68, 0.3), Color(0.45, 0.85, 0.5), Color(1.0, 0.48, 0.55)
]
## The final objects, with the index of their world.
const FINAL: Dictionary[String, int] = {
	"ring": 0, "ball": 0, "axis": 0, "dot": 0, "moved": 0, "lone": 1, "guest": 1, "pair": 1
}

var _worlds: Array[Node3D] = []
var _nodes: Dictionary[String, GANode3D] = {}
var _frame := -1


## With `through_changes`, the final state is reached after four frames.
static func make(through_changes: bool) -> DrawnChanges:
	var picture := DrawnChanges.new()
	picture.set_anchors_preset(PRESET_FULL_RECT)
	var row := HBoxContainer.new()
	row.set_anchors_preset(PRESET_FULL_RECT)
	picture.add_child(row)
	for i in 2:
		row.add_child(picture._view())
	if through_changes:
		picture._begin()
		picture._frame = 0
	else:
		picture._build_final()
	return picture


func _process(_delta: float) -> void:
	if _frame < 0:
		return
	_frame += 1
	match _frame:
		1:
			_hide_and_free()
		2:
			_change_values()
		3:
			_change_worlds()
		4:
			_show_again()


func _view() -> Control:
	var container := SubViewportContainer.new()
	container.stretch = true
	container.size_flags_horizontal = SIZE_EXPAND_FILL
	container.size_flags_vertical = SIZE_EXPAND_FILL
	var view := SubViewport.new()
	view.own_world_3d = true
	container.add_child(view)
	var camera := Camera3D.new()
	camera.look_at_from_position(Vector3(1.0, 2.0, 7.0), Vector3.ZERO)
	view.add_child(camera)
	var world := Node3D.new()
	view.add_child(world)
	_worlds.append(world)
	return container


func _add(title: String, value: Multivector, color: int, parent: Node3D) -> GANode3D:
	var node := GANode3D.new()
	node.multivector = value
	node.color = COLORS[color]
	parent.add_child(node)
	_nodes[title] = node
	return node


func _final_value(title: String) -> Multivector:
	var values: Dictionary[String, Multivector] = {
		"ring": Multivector.circle(Vector3(-2, 0, 0), Vector3(1, 2, 1).normalized(), 1.2),
		"ball": Multivector.sphere(Vector3(1.5, 0, 0), 1.1),
		"axis": Multivector.line(Vector3(0, -1, 0), Vector3(2, 0.5, 0.2).normalized()),
		"dot": Multivector.point(Vector3(0, 2, 0)),
		"moved": Multivector.circle(Vector3.ZERO, Vector3.BACK, 0.5),
		"lone": Multivector.sphere(Vector3(0, 0.5, 0), 1.0),
		"guest": Multivector.circle(Vector3(0, -1, 0), Vector3.UP, 1.5),
		"pair": Multivector.point_pair(Vector3(-2, 1, 0), Vector3(2, 2, 0)),
	}
	return values[title]


func _build_final() -> void:
	for title: String in FINAL:
		_add(
			title,
			_final_value(title),
			FINAL.keys().find(title) % COLORS.size(),
			_worlds[FINAL[title]]
		)
	_finish_moved()
	_nodes["axis"].line_width = 4.0


func _finish_moved() -> void:
	_nodes["moved"].transform = Transform3D(
		Basis.from_euler(Vector3(0.3, 0.7, 0.0)).scaled(Vector3.ONE * 1.5), Vector3(-0.5, 1.0, 1.0)
	)


## Enough circles to make the batch grow more than once, under a temporary parent. The final objects
## start different.
func _begin() -> void:
	var crowd := Node3D.new()
	crowd.name = "Crowd"
	_worlds[0].add_child(crowd)
	for i in 11:
		_add(
			"crowd%d" % i,
			Multivector.circle(Vector3(0.4 * i - 2.0, 0, 1), Vector3.UP, 0.6),
			3,
			crowd
		)
	for title: String in FINAL:
		_add(title, Multivector.circle(Vector3(0, 0.2, 0), Vector3.UP, 2.0), 3, _worlds[0])
	for i in range(11, 20):
		_add("crowd%d" % i, Multivector.sphere(Vector3(0.4 * i - 6.0, 0, 1), 0.6), 3, crowd)


func _hide_and_free() -> void:
	for i: int in [0, 5, 10, 19]:
		_nodes["crowd%d" % i].free()
	_nodes["ring"].hide()
	_nodes["crowd3"].get_parent_node_3d().hide()
	# Change hidden nodes, too.
	_nodes["crowd4"].multivector = Multivector.plane(Vector3.UP, 0.0)
	_nodes["ball"].get_parent().remove_child(_nodes["ball"])


func _change_values() -> void:
	for title: String in FINAL:
		_nodes[title].multivector = _final_value(title)
		_nodes[title].color = COLORS[FINAL.keys().find(title) % COLORS.size()]
	_nodes["axis"].line_width = 4.0
	_finish_moved()
	_nodes["crowd3"].get_parent_node_3d().show()


func _change_worlds() -> void:
	for title: String in FINAL:
		if FINAL[title] == 1:
			_nodes[title].reparent(_worlds[1], false)
	var crowd := _nodes["crowd3"].get_parent_node_3d()
	crowd.reparent(_worlds[1], false)
	_worlds[0].add_child(_nodes["ball"])


func _show_again() -> void:
	_nodes["ring"].show()
	_worlds[1].get_node(^"Crowd").free()
