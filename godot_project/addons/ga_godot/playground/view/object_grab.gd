@tool
extends RefCounted
## Starts a drag of an object that the user grabs outside its handles.

const Picking := preload("picking.gd")
const ViewHandle := preload("view_handle.gd")
const ViewRay := preload("view_ray.gd")


## Returns the handle that moves the object, adjusted so that the grabbed point stays under the
## mouse. For objects through points, returns the handle of the point under the mouse. Returns null
## if the object cannot be moved.
static func take(node: GANode3D, camera: Camera3D, point: Vector2) -> ViewHandle:
	var handles := ViewHandle.of(node, camera)
	for handle: ViewHandle in handles:
		if handle.handle["moves_body"]:
			var position: Vector3 = handle.handle["position"]
			var grabbed := _point_under(
				node, ViewRay.new(camera, point, node.global_transform), position
			)
			handle.handle["grab"] = grabbed - position if grabbed.is_finite() else Vector3.ZERO
			# The drag starts at the mouse, not at the handle.
			handle.position = point
			return handle
	return Picking.find_handle(handles, point)


static func _point_under(node: GANode3D, ray: ViewRay, position: Vector3) -> Vector3:
	var facts := Picking.classify(node)
	var found := Vector3.INF
	match facts.get("kind", &""):
		&"sphere":
			found = ray.meet_sphere(facts["center"] as Vector3, facts["radius"] as float)
		&"plane":
			found = ray.meet_plane(facts["normal"] as Vector3, facts["distance"] as float)
		&"line":
			found = ray.meet_line(facts["center"] as Vector3, facts["direction"] as Vector3)
	return found if found.is_finite() else ray.meet_plane(ray.view, position.dot(ray.view))
