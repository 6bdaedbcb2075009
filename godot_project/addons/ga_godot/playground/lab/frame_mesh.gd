@tool
extends RefCounted
## A frame of axes: x red, y green, z blue, from a small hub at the origin.

## Of an axis at scale 1, in metres.
const LENGTH := 0.5
const HUB := 0.07

const AXIS_COLORS: Array[Color] = [
	Color(0.93, 0.34, 0.36), Color(0.46, 0.76, 0.3), Color(0.32, 0.56, 0.95)
]


## The three axes as bars of that thickness in metres, with vertex colours.
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


## The hub as a further surface of a mesh, for a material of its own.
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
