extends Node3D
## A plane moves through a sphere, and the expression `meet(ball, ground)` follows it. A door opens
## along the screw motion between two poses. Select a drawn node to edit its document in the dock.

var _time := 0.0

@onready var _ring: GANode3D = $Ring
@onready var _door: MultivectorLerp = $DoorMotion
@onready var _label: Label = $Label


func _process(delta: float) -> void:
	_time += delta
	_ring.scene.set_parameter("height", "value", snappedf(1.0 + 1.2 * sin(_time), 0.001))
	_door.factor = 0.5 - 0.5 * cos(_time)
	_label.text = "meet(ball, ground): %s" % _ring.scene.get_description("ring")
