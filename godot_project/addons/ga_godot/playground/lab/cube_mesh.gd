@tool
extends RefCounted
## Two meshes of a cube: solid with a color for each positive axis, and the edges only.

## Edge length at scale 1, in meters.
const EDGE := 0.5

const FACE_COLORS: Dictionary[Vector3, Color] = {
	Vector3.RIGHT: Color(0.86, 0.42, 0.42),
	Vector3.UP: Color(0.46, 0.66, 0.44),
	Vector3.BACK: Color(0.42, 0.61, 0.88),
	Vector3.LEFT: Color(0.74, 0.76, 0.8),
	Vector3.DOWN: Color(0.74, 0.76, 0.8),
	Vector3.FORWARD: Color(0.74, 0.76, 0.8),
}


## A cube with vertex colors: +X red, +Y green, +Z blue, the others gray.
static func solid() -> ArrayMesh:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	for normal: Vector3 in FACE_COLORS:
		var u := Vector3(normal.y, normal.z, normal.x).abs()
		var v := normal.cross(u)
		tool.set_normal(normal)
		tool.set_color(FACE_COLORS[normal])
		var corners: Array[Vector3] = [-u - v, -u + v, u + v, u - v]
		# Front faces are clockwise when seen from outside.
		for index: int in [0, 1, 2, 0, 2, 3]:
			tool.add_vertex((normal + corners[index]) * (EDGE / 2.0))
	return tool.commit()


## The twelve edges as bars. The thickness is in meters.
static func edges(thickness: float) -> ArrayMesh:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	var half := EDGE / 2.0
	for axis in 3:
		var bar := BoxMesh.new()
		bar.size = Vector3.ONE * thickness
		bar.size[axis] = EDGE + thickness
		for signs: Vector2 in [Vector2(-1, -1), Vector2(-1, 1), Vector2(1, -1), Vector2(1, 1)]:
			var offset := Vector3.ZERO
			offset[(axis + 1) % 3] = signs.x * half
			offset[(axis + 2) % 3] = signs.y * half
			tool.append_from(bar, 0, Transform3D(Basis.IDENTITY, offset))
	return tool.commit()
