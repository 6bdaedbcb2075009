@tool
extends RefCounted
## A path as a ribbon of constant width in pixels: its mesh, and the material with
## path_ribbon.gdshader.

const PlaygroundStyle := preload("../theme/playground_style.gd")
const SHADER := preload("path_ribbon.gdshader")

## Width of the ribbon in pixels.
const WIDTH := 3.0

## Points closer than this, in meters, are merged.
const MIN_POINT_DISTANCE := 1e-5


static func make_material(color: Color) -> ShaderMaterial:
	var material := ShaderMaterial.new()
	material.shader = SHADER
	material.set_shader_parameter(&"color", color)
	material.set_shader_parameter(&"width_in_pixels", WIDTH * PlaygroundStyle.scale())
	return material


## Rebuilds the mesh; it stays empty if all points coincide.
static func build(mesh: ArrayMesh, points: PackedVector3Array) -> void:
	mesh.clear_surfaces()
	var line := _without_repeats(points)
	var count := line.size()
	if count < 2:
		return
	var vertices := PackedVector3Array()
	var directions := PackedVector3Array()
	var sides := PackedVector2Array()
	vertices.resize(2 * count)
	directions.resize(2 * count)
	sides.resize(2 * count)
	for i in count:
		var direction := (line[mini(i + 1, count - 1)] - line[maxi(i - 1, 0)]).normalized()
		vertices[2 * i] = line[i]
		vertices[2 * i + 1] = line[i]
		directions[2 * i] = direction
		directions[2 * i + 1] = direction
		sides[2 * i] = Vector2(-1.0, 0.0)
		sides[2 * i + 1] = Vector2(1.0, 0.0)
	var arrays: Array = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = vertices
	arrays[Mesh.ARRAY_NORMAL] = directions
	arrays[Mesh.ARRAY_TEX_UV] = sides
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLE_STRIP, arrays)


static func _without_repeats(points: PackedVector3Array) -> PackedVector3Array:
	var line := PackedVector3Array()
	for point in points:
		if (
			line.is_empty()
			or line[-1].distance_squared_to(point) > MIN_POINT_DISTANCE * MIN_POINT_DISTANCE
		):
			line.append(point)
	return line
