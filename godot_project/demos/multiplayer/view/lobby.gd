extends Control
signal chosen
func _init(_o: RefCounted, _m: String) -> void:
	chosen.emit()
