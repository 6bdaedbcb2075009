extends MultiMeshInstance3D
## All cubes in one MultiMesh, at first where the scene begins.

const Layout := preload("../world/layout.gd")


## [param body_count] instances, of which the cubes, the first, are drawn.
func _init(layout: Layout, body_count: int) -> void:
	var mesh := BoxMesh.new()
	mesh.size = Vector3.ONE * Layout.EDGE
	var material := ShaderMaterial.new()
	material.shader = preload("cube.gdshader")
	material.set_shader_parameter("half_edge", Layout.EDGE * 0.5)
	mesh.material = material
	multimesh = MultiMesh.new()
	multimesh.transform_format = MultiMesh.TRANSFORM_3D
	multimesh.use_colors = true
	multimesh.mesh = mesh
	multimesh.instance_count = body_count
	# The balls' poses stand after the cubes' and are drawn otherwise.
	multimesh.visible_instance_count = layout.poses.size()
	for i: int in layout.poses.size():
		multimesh.set_instance_color(i, layout.colors[i])
		multimesh.set_instance_transform(i, layout.poses[i])
	# The bodies move: a box around all of the arena spares finding it each frame.
	var half := layout.half_extent
	custom_aabb = AABB(Vector3(-half, -1.0, -half), Vector3(2.0 * half, 30.0, 2.0 * half))
