extends Node
## One way to move the cubes in each frame: a subject of the benchmark. It works in its _process, while it is in the tree.

const World := preload("res://tests/bench/engine/world.gd")

var world: World


func _init(of_world: World) -> void:
	world = of_world


## Its turn begins or ends. Outside the tree it costs the others nothing, which a paused node does.
func set_active(active: bool) -> void:
	if active:
		world.get_parent().add_child(self)
	else:
		world.get_parent().remove_child(self)
