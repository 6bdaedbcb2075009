@tool
extends RefCounted
## The body that is drawn at a pose: a cube or a coordinate frame.

const CubeMesh := preload("cube_mesh.gd")
const FrameMesh := preload("frame_mesh.gd")

const CUBE := &"cube"
const FRAME := &"frame"
const KINDS: Array[StringName] = [FRAME, CUBE]
const TITLES: Dictionary[StringName, String] = {CUBE: "Cube", FRAME: "Frame"}

## Thickness of edges or axes at scale 1, in meters.
const THICKNESS: Dictionary[StringName, float] = {CUBE: 0.022, FRAME: 0.017}
const GHOST_THICKNESS: Dictionary[StringName, float] = {CUBE: 0.014, FRAME: 0.011}
const GHOST_ALPHA := 0.45


## The moving body. Its edges or its hub have the color of the mode.
static func solid(kind: StringName, color: Color) -> ArrayMesh:
	var mesh := CubeMesh.solid() if kind == CUBE else FrameMesh.axes(THICKNESS[kind])
	mesh.surface_set_material(0, _make_vertex_color_material(1.0))
	if kind == CUBE:
		mesh.add_surface_from_arrays(
			Mesh.PRIMITIVE_TRIANGLES, CubeMesh.edges(THICKNESS[kind]).surface_get_arrays(0)
		)
	else:
		FrameMesh.add_hub(mesh)
	mesh.surface_set_material(1, _make_colored_material(color))
	return mesh


## The translucent body at a step of the path.
static func ghost(kind: StringName, color: Color) -> ArrayMesh:
	var faint := Color(color, GHOST_ALPHA)
	if kind == CUBE:
		var edges := CubeMesh.edges(GHOST_THICKNESS[kind])
		edges.surface_set_material(0, _make_colored_material(faint))
		return edges
	var mesh := FrameMesh.axes(GHOST_THICKNESS[kind])
	mesh.surface_set_material(0, _make_vertex_color_material(GHOST_ALPHA))
	FrameMesh.add_hub(mesh)
	mesh.surface_set_material(1, _make_colored_material(faint))
	return mesh


static func _make_colored_material(color: Color) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.albedo_color = color
	if color.a < 1.0:
		material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	return material


# Unshaded, as the scene may have no lights.
static func _make_vertex_color_material(alpha: float) -> StandardMaterial3D:
	var material := _make_colored_material(Color(1.0, 1.0, 1.0, alpha))
	material.vertex_color_use_as_albedo = true
	material.vertex_color_is_srgb = true
	return material
