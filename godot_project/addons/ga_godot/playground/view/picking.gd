@tool
extends RefCounted
## Finds what is under the mouse: handles first, then points, curves and surfaces.

const ViewScale := preload("view_scale.gd")
const ViewHandle := preload("view_handle.gd")
const ViewRay := preload("view_ray.gd")

const POINTS: Array[StringName] = [&"point", &"flat_point", &"point_pair", &"tangent"]
const SURFACES: Array[StringName] = [&"sphere", &"plane"]


## Returns the nearest visible handle within the pick radius, or null.
static func find_handle(handles: Array[RefCounted], point: Vector2) -> ViewHandle:
	var best: ViewHandle = null
	var reach := ViewScale.PICK_RADIUS * ViewScale.PlaygroundStyle.scale()
	for handle: ViewHandle in handles:
		var distance := handle.position.distance_to(point)
		if handle.is_visible and distance < reach:
			best = handle
			reach = distance
	return best


## Returns the node of the object at a point of the screen, or null. With `with_faces`, spheres and
## planes are picked anywhere on their surface, otherwise only at their lines, as they may cover
## much of the view.
static func find_object(
	nodes: Array[GANode3D], camera: Camera3D, point: Vector2, with_faces: bool
) -> GANode3D:
	var best: GANode3D = null
	var best_rank := INF
	for node in nodes:
		var rank := _rank(node, camera, point, with_faces)
		if rank < best_rank:
			best = node
			best_rank = rank
	return best


## The classification of the value as it is drawn.
static func classify(node: GANode3D) -> Dictionary:
	var value := node.get_value()
	if value == null:
		return {}
	var dual: bool = (
		node.ipns
		or (
			node.scene != null
			and node.scene.has_entry(node.entry)
			and node.scene.get_entry_attribute(node.entry, "ipns")
		)
	)
	return value.classify(dual)


# Returns the rank of the object, of which the lowest is picked. It is infinite if the object is not
# under the mouse.
static func _rank(node: GANode3D, camera: Camera3D, point: Vector2, with_faces: bool) -> float:
	if not node.is_visible_in_tree():
		return INF
	var pixels := node.get_screen_distance(camera, point)
	var reach := ViewScale.PICK_RADIUS * ViewScale.PlaygroundStyle.scale()
	if pixels > reach:
		return INF
	var facts := classify(node)
	var kind: StringName = facts.get("kind", &"")
	if kind in POINTS:
		return pixels
	if kind not in SURFACES:
		return reach + pixels
	if kind == &"plane":
		return 1e30 if with_faces or pixels > 0.0 else INF
	# The smallest of nested spheres is picked; a sphere around the eye comes last, before planes.
	var center: Vector3 = facts["center"]
	var radius: float = facts["radius"]
	var eye := node.global_transform.affine_inverse() * camera.global_position
	if with_faces:
		return 1e29 if eye.distance_to(center) < radius else 1e6 + minf(radius, 1e20)
	return 2.0 * reach if _is_on_outline(node, camera, point, center, radius, reach) else INF


static func _is_on_outline(
	node: GANode3D, camera: Camera3D, point: Vector2, center: Vector3, radius: float, reach: float
) -> bool:
	var ray := ViewRay.new(camera, point, node.global_transform)
	var nearest := ray.closest_to(center)
	var pixel := (
		ViewScale.pixel(camera, node.global_transform * nearest)
		/ node.global_transform.basis.x.length()
	)
	return absf(nearest.distance_to(center) - radius) < reach * pixel
