extends Node3D
## A node that calls [member moved] from its notification whenever its transform is set: within the
## call that sets it.

## Takes this node.
var moved := Callable()
## Number of calls, including those without [member moved].
var count := 0


func _init(callback := Callable()) -> void:
	moved = callback
	set_notify_local_transform(true)


func _notification(what: int) -> void:
	if what == NOTIFICATION_LOCAL_TRANSFORM_CHANGED:
		count += 1
		if moved.is_valid():
			moved.call(self)
