extends RefCounted
## A thin tube along a polyline, so that a path has the same look at every angle and on every driver.

const SIDES := 6


## The tube's mesh; points closer than a hundredth of a millimetre are skipped. An empty mesh when
## fewer than two remain.
static func build(points: PackedVector3Array, radius: float) -> ArrayMesh:
	var mesh := ArrayMesh.new()
	var line := _without_repeats(points)
	if line.size() < 2:
		return mesh
	var vertices := PackedVector3Array()
	var indices := PackedInt32Array()
	var side := _any_perpendicular(line[1] - line[0])
	for i in line.size():
		var ahead := line[mini(i + 1, line.size() - 1)] - line[maxi(i - 1, 0)]
		var along := ahead.normalized()
		# Carrying the side vector on keeps the tube from twisting.
		side = (side - along * along.dot(side)).normalized()
		var up := along.cross(side)
		for k in SIDES:
			var angle := TAU * k / SIDES
			vertices.append(line[i] + (side * cos(angle) + up * sin(angle)) * radius)
		if i > 0:
			_append_ring(indices, (i - 1) * SIDES)
	var arrays: Array = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = vertices
	arrays[Mesh.ARRAY_INDEX] = indices
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh


static func _append_ring(indices: PackedInt32Array, base: int) -> void:
	for k in SIDES:
		var a := base + k
		var b := base + (k + 1) % SIDES
		indices.append_array([a, b, a + SIDES, b, b + SIDES, a + SIDES])


static func _without_repeats(points: PackedVector3Array) -> PackedVector3Array:
	var line := PackedVector3Array()
	for point in points:
		if line.is_empty() or line[-1].distance_to(point) > 1e-5:
			line.append(point)
	return line


static func _any_perpendicular(direction: Vector3) -> Vector3:
	var other := Vector3.UP if absf(direction.normalized().y) < 0.9 else Vector3.RIGHT
	return direction.cross(other).normalized()
