@tool
extends RefCounted
## Adds an object where the user clicks in the view: on the sphere or plane under the mouse, or on
## the ground plane y = 0.

const EntryEdits := preload("../document/entry_edits.gd")
const NewObjects := preload("../document/new_objects.gd")
const Picking := preload("picking.gd")
const SceneDrawing := preload("scene_drawing.gd")
const ViewRay := preload("view_ray.gd")
const ViewScale := preload("view_scale.gd")

## Radius of new objects, in pixels.
const SIZE := 70.0
## Distance from the eye if nothing is hit, and the maximum distance of a hit, in meters.
const DEPTH := 5.0
const MAX_DISTANCE := 1000.0
## {position}: the coordinates of the hit; {other}: a point above it; {normal} and {distance}: those
## of the tangent plane at the hit; {length}: a radius.
const EXPRESSIONS: Dictionary[StringName, String] = {
	&"point": "point({position})",
	&"pair": "point_pair(point({position}), point({other}))",
	&"line": "line(point({position}), {normal})",
	&"circle": "circle(point({position}), {normal}, {length})",
	&"plane": "plane({normal}, {distance})",
	&"sphere": "sphere(point({position}), {length})",
	&"motor": "motor(vector({position}), rotor({normal}, deg(90)), 1)",
	&"scalar": "1",
}
const AXES: Dictionary[Vector3, String] = {
	Vector3.RIGHT: "e1",
	Vector3.UP: "e2",
	Vector3.BACK: "e3",
	Vector3.LEFT: "-e1",
	Vector3.DOWN: "-e2",
	Vector3.FORWARD: "-e3",
}


## Returns the "position" of the hit and the "normal" of the surface, which faces the camera, in the
## space of the drawing.
static func find_hit(
	drawing: SceneDrawing, camera: Camera3D, point: Vector2
) -> Dictionary[String, Vector3]:
	var ray := ViewRay.new(camera, point, drawing.global_transform)
	var position := ray.meet_plane(Vector3.UP, 0.0)
	var normal := Vector3.UP
	if position.distance_to(ray.origin) > MAX_DISTANCE:
		position = Vector3.INF
	for node in drawing.get_nodes():
		var facts := Picking.classify(node)
		var found := Vector3.INF
		var surface_normal := Vector3.UP
		if facts.get("kind") == &"plane":
			surface_normal = facts["normal"]
			found = ray.meet_plane(surface_normal, facts["distance"] as float)
		elif facts.get("kind") == &"sphere" and not facts["imaginary"]:
			found = ray.meet_sphere(facts["center"] as Vector3, facts["radius"] as float)
			surface_normal = (found - (facts["center"] as Vector3)).normalized()
		# Hidden objects are at an infinite distance on the screen.
		var is_drawn := (
			node.is_visible_in_tree() and is_finite(node.get_screen_distance(camera, point))
		)
		if (
			is_drawn
			and found.is_finite()
			and (
				found.distance_to(ray.origin)
				<= minf(position.distance_to(ray.origin), MAX_DISTANCE)
			)
		):
			position = found
			normal = surface_normal if surface_normal.dot(ray.direction) < 0.0 else -surface_normal
	if not position.is_finite():
		position = ray.origin + ray.direction * DEPTH
	return {"position": position, "normal": normal}


## Returns the name of the new entry.
static func add(
	edits: EntryEdits,
	drawing: SceneDrawing,
	kind: StringName,
	camera: Camera3D,
	point: Vector2,
	snaps: bool
) -> String:
	var found := find_hit(drawing, camera, point)
	var pixel := ViewScale.pixel(camera, drawing.global_transform * found["position"])
	var step := ViewScale.coarse_step(pixel) if snaps else ViewScale.fine_step(pixel)
	var length := ViewScale.round_length(pixel, SIZE * ViewScale.PlaygroundStyle.scale())
	var position := found["position"].snappedf(step)
	var normal := found["normal"].snappedf(0.001)
	var expression := (
		EXPRESSIONS[kind]
		. format(
			{
				"position": _coordinates(position, step),
				"other": _coordinates((position + found["normal"] * length).snappedf(step), step),
				"normal": AXES.get(normal, "vector(%s)" % _coordinates(normal, 0.001)),
				"length": String.num(length).trim_suffix(".0"),
				"distance": _number(found["normal"].dot(position), step),
			}
		)
	)
	return edits.add("", expression, false, kind)


static func _coordinates(vector: Vector3, step: float) -> String:
	return (
		"%s, %s, %s" % [_number(vector.x, step), _number(vector.y, step), _number(vector.z, step)]
	)


static func _number(value: float, step: float) -> String:
	# Adding 0.0 turns -0.0 into 0.0.
	return (
		String
		. num(snappedf(value, step) + 0.0, maxi(0, roundi(-log(step) / log(10.0))))
		. trim_suffix(".0")
	)
