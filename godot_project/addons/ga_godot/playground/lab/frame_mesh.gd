@tool
extends RefCounted
## A coordinate frame: x red, y green and z blue, with a small hub at the origin.

## Length of an axis and edge of the hub at scale 1, in meters.
const LENGTH := 0.5
const HUB := 0.07

const AXIS_COLORS: Array[Color] = [
	Color(0.93, 0.34, 0.36), Color(0.46, 0.76, 0.3), Color(0.32, 0.56, 0.95)
]


## The three axes as bars with vertex colors. The thickness is in meters.
static func axes(thickness: float) -> ArrayMesh:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	for axis in 3:
		var bar := BoxMesh.new()
		bar.size = Vector3.ONE * thickness
		bar.size[axis] = LENGTH
		var offset := Vector3.ZERO
		offset[axis] = LENGTH / 2.0
		_append(tool, bar, offset, AXIS_COLORS[axis])
	return tool.commit()


## Adds the hub as a separate surface, so that it can have its own material.
static func add_hub(mesh: ArrayMesh) -> void:
	var hub := BoxMesh.new()
	hub.size = Vector3.ONE * HUB
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, hub.get_mesh_arrays())


static func _append(tool: SurfaceTool, mesh: PrimitiveMesh, offset: Vector3, color: Color) -> void:
	var arrays := mesh.get_mesh_arrays()
	var vertices: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var normals: PackedVector3Array = arrays[Mesh.ARRAY_NORMAL]
	var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
	for index in indices:
		tool.set_normal(normals[index])
		tool.set_color(color)
		tool.add_vertex(vertices[index] + offset)
