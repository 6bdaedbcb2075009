extends RefCounted
## Reference implementations of the three modes of interpolation with the engine's quaternions and
## transforms, in single precision.


## Dual quaternion linear blending, with separate interpolation of the scale.
static func linear(from: Transform3D, to: Transform3D, weight: float) -> Transform3D:
	var first := from.basis.get_rotation_quaternion()
	var second := to.basis.get_rotation_quaternion()
	var sign_of_second := -1.0 if first.dot(second) < 0.0 else 1.0
	var real := first * (1.0 - weight) + second * (weight * sign_of_second)
	var dual := (
		_half_translation(from.origin) * first * (1.0 - weight)
		+ _half_translation(to.origin) * second * (weight * sign_of_second)
	)
	var moved := (
		dual * Quaternion(-real.x, -real.y, -real.z, real.w) * (2.0 / real.length_squared())
	)
	return _compose(
		Vector3(moved.x, moved.y, moved.z), real.normalized(), _blended_scale(from, to, weight)
	)


static func separate(from: Transform3D, to: Transform3D, weight: float) -> Transform3D:
	var rotation := from.basis.get_rotation_quaternion().slerp(
		to.basis.get_rotation_quaternion(), weight
	)
	return _compose(from.origin.lerp(to.origin, weight), rotation, _blended_scale(from, to, weight))


## Returns the pose after [param count] steps of the motion from [param from] to [param first_step].
## With the first of n equal steps of a screw path, n steps must reach its end.
static func repeat_motion(from: Transform3D, first_step: Transform3D, count: int) -> Transform3D:
	var motion := first_step * from.affine_inverse()
	var pose := from
	for i in count:
		pose = motion * pose
	return pose


static func _blended_scale(from: Transform3D, to: Transform3D, weight: float) -> float:
	return lerpf(from.basis.get_scale().x, to.basis.get_scale().x, weight)


static func _half_translation(origin: Vector3) -> Quaternion:
	return Quaternion(origin.x * 0.5, origin.y * 0.5, origin.z * 0.5, 0.0)


static func _compose(translation: Vector3, rotation: Quaternion, scale: float) -> Transform3D:
	return Transform3D(Basis(rotation).scaled(Vector3.ONE * scale), translation)
