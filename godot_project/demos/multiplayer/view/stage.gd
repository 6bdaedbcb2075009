extends Node3D
## Sky, lights, floor and rim of the arena on a client.

const Palette := preload("palette.gd")
const Scenario := preload("../world/scenario.gd")

const RIM_HEIGHT := 0.28
const RIM_WIDTH := 0.22
const FLOOR_MARGIN := 160.0


func _init(scene: String, half_extent: float) -> void:
	add_child(_make_environment())
	_add_lights(half_extent)
	add_child(_make_floor(half_extent, scene == "cubes"))
	for side: float in [-1.0, 1.0]:
		var at := side * (half_extent + RIM_WIDTH * 0.5)
		var length := 2.0 * (half_extent + RIM_WIDTH)
		add_child(_make_rim(Vector3(at, 0.0, 0.0), Vector3(RIM_WIDTH, RIM_HEIGHT, length)))
		add_child(_make_rim(Vector3(0.0, 0.0, at), Vector3(length, RIM_HEIGHT, RIM_WIDTH)))


func _make_environment() -> WorldEnvironment:
	var material := ProceduralSkyMaterial.new()
	material.sky_top_color = Palette.SKY_TOP
	material.sky_horizon_color = Palette.SKY_HORIZON
	material.ground_bottom_color = Palette.SKY_TOP
	material.ground_horizon_color = Palette.SKY_HORIZON
	material.sky_curve = 0.09
	material.sun_angle_max = 0.0
	var sky := Sky.new()
	sky.sky_material = material
	var environment := Environment.new()
	environment.background_mode = Environment.BG_SKY
	environment.sky = sky
	environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	environment.ambient_light_color = Color("8fa3cc")
	environment.ambient_light_energy = 0.38
	environment.tonemap_mode = Environment.TONE_MAPPER_FILMIC
	environment.tonemap_white = 2.2
	environment.fog_enabled = true
	environment.fog_light_color = Palette.SKY_HORIZON
	environment.fog_density = 0.006
	environment.fog_sky_affect = 0.0
	environment.glow_enabled = true
	environment.glow_intensity = 0.5
	environment.glow_bloom = 0.04
	var world := WorldEnvironment.new()
	world.environment = environment
	return world


func _add_lights(half_extent: float) -> void:
	var key := DirectionalLight3D.new()
	key.rotation_degrees = Vector3(-52.0, -38.0, 0.0)
	key.light_color = Palette.KEY_LIGHT
	key.light_energy = 1.75
	key.shadow_enabled = true
	key.directional_shadow_mode = DirectionalLight3D.SHADOW_ORTHOGONAL
	key.directional_shadow_max_distance = half_extent * 4.0
	key.shadow_blur = 1.4
	add_child(key)
	var rim := DirectionalLight3D.new()
	rim.rotation_degrees = Vector3(-24.0, 140.0, 0.0)
	rim.light_color = Palette.RIM_LIGHT
	rim.light_energy = 0.5
	add_child(rim)


func _make_floor(half_extent: float, has_lifts: bool) -> MeshInstance3D:
	var mesh := PlaneMesh.new()
	mesh.size = Vector2.ONE * 2.0 * (half_extent + FLOOR_MARGIN)
	var material := ShaderMaterial.new()
	material.shader = preload("floor.gdshader")
	material.set_shader_parameter("base", Palette.FLOOR)
	material.set_shader_parameter("line", Palette.FLOOR.lightened(0.45))
	material.set_shader_parameter("lift", Palette.LIFT if has_lifts else Color.BLACK)
	material.set_shader_parameter("half_extent", half_extent)
	var lifts := PackedVector2Array()
	for i: int in Scenario.LIFT_COUNT:
		var at := Scenario.get_lift_position(i)
		lifts.append(Vector2(at.x, at.z))
	material.set_shader_parameter("lifts", lifts)
	var floor_mesh := MeshInstance3D.new()
	floor_mesh.mesh = mesh
	floor_mesh.material_override = material
	return floor_mesh


func _make_rim(center: Vector3, size: Vector3) -> MeshInstance3D:
	var mesh := BoxMesh.new()
	mesh.size = size
	var material := StandardMaterial3D.new()
	material.albedo_color = Palette.ACCENT.darkened(0.55)
	material.emission_enabled = true
	material.emission = Palette.ACCENT
	material.emission_energy_multiplier = 0.35
	material.roughness = 0.5
	var rim := MeshInstance3D.new()
	rim.mesh = mesh
	rim.material_override = material
	rim.position = center + Vector3(0.0, RIM_HEIGHT * 0.5, 0.0)
	return rim
