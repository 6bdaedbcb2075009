@tool
extends RefCounted
## The ray from the camera through a point of the screen, in the local space of a node.

var origin: Vector3
## Unit vector.
var direction: Vector3
## The viewing direction of the camera. Unit vector.
var view: Vector3


## If the transform `space` is not invertible, the direction is zero.
func _init(camera: Camera3D, point: Vector2, space: Transform3D) -> void:
	if is_degenerate(space):
		return
	var inverse := space.affine_inverse()
	origin = inverse * camera.project_ray_origin(point)
	direction = (inverse.basis * camera.project_ray_normal(point)).normalized()
	view = (inverse.basis * -camera.global_basis.z).normalized()


static func is_degenerate(space: Transform3D) -> bool:
	return space.basis.determinant() == 0.0


## The nearest intersection in front of the eye; infinite if there is none.
func meet_sphere(center: Vector3, radius: float) -> Vector3:
	var nearest := direction.dot(center - origin)
	var squared := radius * radius - (origin + direction * nearest - center).length_squared()
	if squared < 0.0 or nearest + sqrt(squared) < 0.0:
		return Vector3.INF
	var depth := nearest - sqrt(squared)
	return origin + direction * (depth if depth > 0.0 else nearest + sqrt(squared))


## The intersection in front of the eye; infinite if there is none.
func meet_plane(normal: Vector3, distance: float) -> Vector3:
	var cosine := direction.dot(normal)
	var depth := (distance - origin.dot(normal)) / cosine if absf(cosine) > 1e-6 else -1.0
	return origin + direction * depth if depth > 0.0 else Vector3.INF


## The point of a line closest to the ray; infinite if they are parallel.
func meet_line(point: Vector3, line_direction: Vector3) -> Vector3:
	var cosine := direction.dot(line_direction)
	var sine_squared := 1.0 - cosine * cosine
	if sine_squared < 1e-9:
		return Vector3.INF
	var offset := origin - point
	return (
		point
		+ (
			line_direction
			* ((offset.dot(line_direction) - cosine * offset.dot(direction)) / sine_squared)
		)
	)


## The point of the ray closest to a point.
func closest_to(point: Vector3) -> Vector3:
	return origin + direction * direction.dot(point - origin)
