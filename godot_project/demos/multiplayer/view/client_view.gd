extends Node3D
func _init(_c: Node, _o: RefCounted) -> void:
	pass
