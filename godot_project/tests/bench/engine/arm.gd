extends Node
## A subject of the benchmark: one method of moving the cubes. It does its work in _process, while
## it is in the tree.

const World := preload("res://tests/bench/engine/world.gd")

var world: World


func _init(of_world: World) -> void:
	world = of_world


## Starts or ends its turn. Unlike a paused node, a node outside the tree costs the others no time.
func set_active(active: bool) -> void:
	if active:
		world.get_parent().add_child(self)
	else:
		world.get_parent().remove_child(self)
