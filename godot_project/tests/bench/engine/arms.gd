extends RefCounted
## The subjects of the benchmark by name. "idle" does nothing and measures the frame itself.

const Arm := preload("res://tests/bench/engine/arm.gd")
const World := preload("res://tests/bench/engine/world.gd")

## A class of the benchmark's own extension, which is not part of the addon.
const NATIVE_CLASS := &"NativeBlend"


static func make_all(world: World) -> Dictionary[String, Arm]:
	return {
		"idle": Arm.new(world),
		"paper_allocating": Native.new(world, &"blend_paper_allocating"),
		"paper_pooled": Native.new(world, &"blend_paper_pooled"),
		"glm_slerp": Native.new(world, &"blend_glm_slerp"),
		"set_transform_cpp": Native.new(world, &"set_only"),
		"set_transform_gdscript": SetOnly.new(world),
		"transform3d_interpolate_with": InScript.new(world),
		"tween": Tweened.new(world),
		"animation_player": Animated.new(world),
		"multivector_lerp": Lerps.new(world, false),
		"multivector_lerp_motors": Lerps.new(world, true),
		"motor_pool_nodes": PoolToNodes.new(world),
		"motor_pool_multimesh": PoolToMultiMesh.new(world),
	}


## A method of NATIVE_CLASS: one call per frame moves all nodes.
class Native:
	extends Arm

	var _blend: RefCounted
	var _method: StringName

	func _init(of_world: World, method: StringName) -> void:
		super(of_world)
		_method = method
		_blend = ClassDB.instantiate(NATIVE_CLASS)
		_blend.call(&"setup", world.nodes, world.from, world.to)

	func _process(_delta: float) -> void:
		_blend.call(_method, world.weight)


## The cost of setting transforms from a script.
class SetOnly:
	extends Arm

	func _process(_delta: float) -> void:
		var nodes := world.nodes
		var from := world.from
		for i in nodes.size():
			nodes[i].transform = from[i]


## Transform3D.interpolate_with, called from a script.
class InScript:
	extends Arm

	func _process(_delta: float) -> void:
		var nodes := world.nodes
		var from := world.from
		var to := world.to
		var weight := world.weight
		for i in nodes.size():
			nodes[i].transform = from[i].interpolate_with(to[i], weight)


## One Tween with a property tweener per node. Stepped here, so that its time counts as work of the
## arm.
class Tweened:
	extends Arm

	const SECONDS := 10_000.0
	const STEP := 1.0

	var _tween: Tween

	func _ready() -> void:
		_tween = create_tween().set_parallel()
		for i in world.nodes.size():
			_tween.tween_property(world.nodes[i], ^"transform", world.to[i], SECONDS).from(
				world.from[i]
			)
		_tween.pause()

	func _process(_delta: float) -> void:
		_tween.custom_step(STEP)


## One AnimationPlayer with a position track and a rotation track per node.
class Animated:
	extends Arm

	var _player := AnimationPlayer.new()

	func _init(of_world: World) -> void:
		super(of_world)
		add_child(_player)

	func _ready() -> void:
		var animation := Animation.new()
		animation.length = 1.0
		for i in world.nodes.size():
			var path := NodePath(world.cubes.get_path_to(world.nodes[i]))
			var position := animation.add_track(Animation.TYPE_POSITION_3D)
			animation.track_set_path(position, path)
			var rotation := animation.add_track(Animation.TYPE_ROTATION_3D)
			animation.track_set_path(rotation, path)
			for end: Array in [[0.0, world.from[i]], [1.0, world.to[i]]]:
				var pose: Transform3D = end[1]
				animation.position_track_insert_key(position, end[0] as float, pose.origin)
				animation.rotation_track_insert_key(
					rotation, end[0] as float, pose.basis.get_rotation_quaternion()
				)
		var library := AnimationLibrary.new()
		library.add_animation(&"all", animation)
		_player.add_animation_library(&"", library)
		_player.callback_mode_process = AnimationMixer.ANIMATION_CALLBACK_MODE_PROCESS_MANUAL
		_player.root_node = _player.get_path_to(world.cubes)
		_player.play(&"all")

	func _process(_delta: float) -> void:
		_player.seek(world.weight, true)


## A MultivectorLerp node per cube, between two nodes or two motors.
class Lerps:
	extends Arm

	const SECONDS := 100.0

	var _motors: bool

	func _init(of_world: World, motors: bool) -> void:
		super(of_world)
		_motors = motors
		for i in world.nodes.size():
			var mover := MultivectorLerp.new()
			mover.local = true
			mover.duration = SECONDS
			if motors:
				mover.start_motor = Multivector.motor(world.from[i])
				mover.end_motor = Multivector.motor(world.to[i])
			add_child(mover)

	func _ready() -> void:
		for i in world.nodes.size():
			var mover := get_child(i) as MultivectorLerp
			mover.target = mover.get_path_to(world.nodes[i])
			if not _motors:
				mover.start = mover.get_path_to(_add_end(mover, world.from[i]))
				mover.end = mover.get_path_to(_add_end(mover, world.to[i]))
			mover.play()

	func _add_end(mover: MultivectorLerp, pose: Transform3D) -> Node3D:
		var end := Node3D.new()
		end.transform = pose
		mover.add_child(end)
		return end


class PoolToNodes:
	extends Arm

	var _pool := MotorPool.new()

	func _init(of_world: World) -> void:
		super(of_world)
		_pool.reserve(world.nodes.size())
		for i in world.nodes.size():
			_pool.acquire()
		_pool.set_from_all(world.from)
		_pool.set_to_all(world.to)

	func _process(_delta: float) -> void:
		_pool.interpolate(world.weight, MultivectorLerp.LINEAR)
		_pool.apply_to_nodes(world.nodes)


class PoolToMultiMesh:
	extends PoolToNodes

	func set_active(active: bool) -> void:
		super(active)
		world.show_multimesh(active)

	func _process(_delta: float) -> void:
		_pool.interpolate(world.weight, MultivectorLerp.LINEAR)
		_pool.apply_to_multimesh(world.multimesh_instance.multimesh)
