@tool
extends RefCounted
## What is seen through a place of the screen, in the space of a node.

var origin: Vector3
## Unit.
var direction: Vector3
## Where the camera looks to. Unit.
var view: Vector3


func _init(camera: Camera3D, point: Vector2, space: Transform3D) -> void:
	var inverse := space.affine_inverse()
	origin = inverse * camera.project_ray_origin(point)
	direction = (inverse.basis * camera.project_ray_normal(point)).normalized()
	view = (inverse.basis * -camera.global_basis.z).normalized()


## The nearer place in front of the eye; infinite if there is none.
func meet_sphere(center: Vector3, radius: float) -> Vector3:
	var nearest := direction.dot(center - origin)
	var squared := radius * radius - (origin + direction * nearest - center).length_squared()
	if squared < 0.0 or nearest + sqrt(squared) < 0.0:
		return Vector3.INF
	var depth := nearest - sqrt(squared)
	return origin + direction * (depth if depth > 0.0 else nearest + sqrt(squared))


## Infinite if there is none in front of the eye.
func meet_plane(normal: Vector3, distance: float) -> Vector3:
	var cosine := direction.dot(normal)
	var depth := (distance - origin.dot(normal)) / cosine if absf(cosine) > 1e-6 else -1.0
	return origin + direction * depth if depth > 0.0 else Vector3.INF


## The place of a line that is nearest to the ray.
func meet_line(point: Vector3, along: Vector3) -> Vector3:
	var cosine := direction.dot(along)
	var across := 1.0 - cosine * cosine
	if across < 1e-9:
		return Vector3.INF
	var between := origin - point
	return point + along * ((between.dot(along) - cosine * between.dot(direction)) / across)


## The place of the ray that is nearest to a point.
func pass_by(point: Vector3) -> Vector3:
	return origin + direction * direction.dot(point - origin)
