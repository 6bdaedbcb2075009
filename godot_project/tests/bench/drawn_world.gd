extends Node3D
## 1,000 objects of mixed kinds in view, 200 of which can be changed: GANode3D nodes, or
## MeshInstance3D nodes with the engine's primitives of about the same size on the screen.

const DrawnWorld := preload("res://tests/bench/drawn_world.gd")

const SUBJECTS: Array[StringName] = [&"ga_godot", &"engine_primitives"]
## The number of objects by kind.
const KINDS: Dictionary[StringName, int] = {
	&"point": 300,
	&"pair": 150,
	&"line": 150,
	&"circle": 200,
	&"sphere": 150,
	&"plane": 30,
	&"motor": 20,
}
const CHANGING := 200
## The number of positions that a changing object cycles through.
const PHASES := 8
const EXTENT := 10.0
const RADIUS := 0.5
## The radius of thin primitives in meters: about two pixels at the distance of most objects.
const THIN := 0.02

# Shared by all nodes, as usual for the engine's primitives.
static var _meshes: Dictionary[StringName, Mesh] = {}
static var _materials: Dictionary[String, StandardMaterial3D] = {}

var _colors: Array[Color] = [
	Color(0.36, 0.72, 1.0), Color(1.0, 0.68, 0.3), Color(0.45, 0.85, 0.5), Color(1.0, 0.48, 0.55)
]
var _random := RandomNumberGenerator.new()
var _nodes: Array[Node3D] = []
# The multivectors or transforms of the first CHANGING nodes, one for each phase.
var _multivectors: Array[Array] = []
var _transforms: Array[Array] = []
var _scene: GAScene


static func make(subject: StringName) -> DrawnWorld:
	var world := DrawnWorld.new()
	world._random.seed = 2026
	# Kinds alternate, so that the same fraction of each kind changes.
	var left: Dictionary[StringName, int] = KINDS.duplicate()
	while not left.is_empty():
		for kind: StringName in left.keys():
			world._add(kind, subject == SUBJECTS[0])
			left[kind] -= 1
			if left[kind] == 0:
				left.erase(kind)
	world._add_camera()
	return world


## 1,000 entries of one document, each with a GANode3D; 200 of them depend on a point that is
## dragged.
static func make_document() -> DrawnWorld:
	var world := DrawnWorld.new()
	world._random.seed = 2026
	world._scene = GAScene.new()
	world._scene.add_entry("p", "point(0, 0, 0)")
	for i in 999:
		var at := world._place()
		var text := "sphere(point(%f, %f, %f), 0.5)" % [at.x, at.y, at.z]
		if i < CHANGING:
			text = "p ^ point(%f, %f, %f) ^ einf" % [at.x, at.y, at.z]
		elif i % 2 == 0:
			text = "point(%f, %f, %f)" % [at.x, at.y, at.z]
		world._scene.add_entry("x%d" % i, text)
	for entry in world._scene.get_names():
		var node := GANode3D.new()
		node.scene = world._scene
		node.entry = entry
		world.add_child(node)
	world._add_camera()
	return world


## Moves the changing objects to their next positions.
func change(frame: int) -> void:
	var phase := frame % PHASES
	if _scene != null:
		_scene.set_parameter("p", "position", Vector3(0.1 * phase, 0.0, 0.0))
	for i in _multivectors.size():
		var node: GANode3D = _nodes[i]
		node.multivector = _multivectors[i][phase]
	for i in _transforms.size():
		_nodes[i].transform = _transforms[i][phase]


func _add_camera() -> void:
	var camera := Camera3D.new()
	camera.fov = 55.0
	camera.look_at_from_position(Vector3(2.5, 4.0, 22.0), Vector3.ZERO)
	add_child(camera)


func _place() -> Vector3:
	return Vector3(
		_random.randf_range(-1.0, 1.0) * EXTENT,
		_random.randf_range(-0.5, 0.5) * EXTENT,
		_random.randf_range(-1.0, 1.0) * EXTENT
	)


func _add(kind: StringName, by_algebra: bool) -> void:
	var index := _nodes.size()
	var place := _place()
	var axis := Vector3(_random.randfn(), _random.randfn(), _random.randfn()).normalized()
	var color := _colors[index % _colors.size()]
	var changes := index < CHANGING
	if by_algebra:
		var node := GANode3D.new()
		node.multivector = _multivector(kind, place, axis)
		node.color = color
		_nodes.append(node)
		if changes:
			var phases: Array[Multivector] = []
			for phase in PHASES:
				phases.append(_multivector(kind, place + _step(phase), axis))
			_multivectors.append(phases)
	else:
		var node := MeshInstance3D.new()
		node.mesh = _mesh(kind)
		node.material_override = _material(color, kind)
		node.transform = _pose(kind, place, axis)
		node.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
		_nodes.append(node)
		if changes:
			var phases: Array[Transform3D] = []
			for phase in PHASES:
				phases.append(_pose(kind, place + _step(phase), axis))
			_transforms.append(phases)
	add_child(_nodes[index])


func _step(phase: int) -> Vector3:
	return Vector3(0.0, 0.1 * phase, 0.0)


func _multivector(kind: StringName, place: Vector3, axis: Vector3) -> Multivector:
	var result: Multivector
	match kind:
		&"point":
			result = Multivector.point(place)
		&"pair":
			result = Multivector.point_pair(place - RADIUS * axis, place + RADIUS * axis)
		&"line":
			result = Multivector.line(place, axis)
		&"circle":
			result = Multivector.circle(place, axis, RADIUS)
		&"sphere":
			result = Multivector.sphere(place, RADIUS)
		&"plane":
			result = Multivector.plane(axis, axis.dot(place))
		_:
			result = Multivector.motor_from(place, Quaternion(axis, 2.0), 1.0)
	return result


func _pose(kind: StringName, place: Vector3, axis: Vector3) -> Transform3D:
	if kind == &"plane":
		place = axis * axis.dot(place)
	return Transform3D(Basis(Quaternion(Vector3.UP, axis)), place)


static func free_shared() -> void:
	_meshes.clear()
	_materials.clear()


static func _mesh(kind: StringName) -> Mesh:
	if not _meshes.has(kind):
		_meshes[kind] = _new_mesh(kind)
	return _meshes[kind]


static func _new_mesh(kind: StringName) -> Mesh:
	match kind:
		&"point":
			var ball := SphereMesh.new()
			ball.radius = 3.0 * THIN
			ball.height = 6.0 * THIN
			return ball
		&"sphere":
			var globe := SphereMesh.new()
			return globe
		&"circle":
			var ring := TorusMesh.new()
			ring.inner_radius = RADIUS - THIN
			ring.outer_radius = RADIUS + THIN
			return ring
		&"plane":
			var plane := PlaneMesh.new()
			plane.size = Vector2(1000.0, 1000.0)
			return plane
		_:
			var rod := CylinderMesh.new()
			rod.top_radius = THIN
			rod.bottom_radius = THIN
			rod.height = 1000.0 if kind == &"line" else 2.0 * RADIUS
			return rod


static func _material(color: Color, kind: StringName) -> StandardMaterial3D:
	var is_face := kind in [&"sphere", &"plane"]
	var key := "%s %s" % [color.to_html(), is_face]
	if not _materials.has(key):
		var material := StandardMaterial3D.new()
		material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
		material.albedo_color = Color(color, 0.2 if is_face else 1.0)
		material.transparency = (
			BaseMaterial3D.TRANSPARENCY_ALPHA if is_face else BaseMaterial3D.TRANSPARENCY_DISABLED
		)
		material.cull_mode = BaseMaterial3D.CULL_DISABLED if is_face else BaseMaterial3D.CULL_BACK
		_materials[key] = material
	return _materials[key]
