extends MultiMeshInstance3D
## All cubes in one MultiMesh, initially at their start poses.

const Layout := preload("../world/layout.gd")


## Creates [param body_count] instances and draws the first ones, the cubes.
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
	# The balls come after the cubes and are drawn by BallView.
	multimesh.visible_instance_count = layout.poses.size()
	for i: int in layout.poses.size():
		multimesh.set_instance_color(i, layout.colors[i])
		multimesh.set_instance_transform(i, layout.poses[i])
	# A fixed box around the arena, so that the engine need not compute bounds each frame.
	var half := layout.half_extent
	custom_aabb = AABB(Vector3(-half, -1.0, -half), Vector3(2.0 * half, 30.0, 2.0 * half))
