extends RefCounted
## A pose as position, Euler angles and scale, which the sliders edit.

const DemoPose := preload("res://demos/interpolation/demo_pose.gd")

## Position in meters.
var position: Vector3
## Euler angles in degrees, in YXZ order.
var rotation_degrees: Vector3
## Uniform scale, above zero.
var scale: float


func _init(p_position := Vector3.ZERO, p_rotation_degrees := Vector3.ZERO, p_scale := 1.0) -> void:
	position = p_position
	rotation_degrees = p_rotation_degrees
	scale = p_scale


func to_transform() -> Transform3D:
	var radians := rotation_degrees * (PI / 180.0)
	var basis := Basis.from_euler(radians).scaled(Vector3.ONE * scale)
	return Transform3D(basis, position)


func duplicate_pose() -> DemoPose:
	return DemoPose.new(position, rotation_degrees, scale)
