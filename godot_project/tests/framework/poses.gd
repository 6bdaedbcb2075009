extends RefCounted
## Poses for tests: degenerate ones by name, and random ones.

const FAR := 10000.0


## The transform that scales uniformly, then rotates, then translates.
static func make(
	translation: Vector3, rotation := Quaternion.IDENTITY, scale := 1.0
) -> Transform3D:
	return Transform3D(Basis(rotation).scaled(Vector3.ONE * scale), translation)


static func degenerate() -> Dictionary[String, Transform3D]:
	return {
		"identity": Transform3D.IDENTITY,
		"zero translation": make(Vector3.ZERO, Quaternion(Vector3.UP, 1.0), 1.5),
		"rotation by pi about x": make(Vector3(1, 2, 3), Quaternion(1, 0, 0, 0)),
		"rotation by pi about y": make(Vector3(-1, 2, 3), Quaternion(0, 1, 0, 0)),
		"rotation by pi about z": make(Vector3(1, -2, 3), Quaternion(0, 0, 1, 0)),
		"rotation by pi about a slanted axis":
		make(Vector3(1, 2, -3), Quaternion(Vector3(1, 1, 1).normalized(), PI)),
		"rotation by almost pi":
		make(Vector3(4, 0, 0), Quaternion(Vector3(1, -2, 1).normalized(), PI - 1e-4)),
		"tiny turn": make(Vector3(1, 0, 0), Quaternion(Vector3.RIGHT, 1e-5)),
		"scale 0.01": make(Vector3(5, 6, 7), Quaternion(Vector3.BACK, 2.0), 0.01),
		"scale 100": make(Vector3(5, 6, 7), Quaternion(Vector3.BACK, 2.0), 100.0),
		"10 km away": make(Vector3(FAR, -FAR, FAR), Quaternion(Vector3.UP, 2.5), 1.0),
		"10 km away and scaled": make(Vector3(-FAR, FAR, FAR), Quaternion(Vector3.UP, -2.5), 4.0),
	}


## A random pose: within 10 m of the origin, any rotation, scale 0.2 to 5.
static func random(generator: RandomNumberGenerator) -> Transform3D:
	var translation := Vector3(
		generator.randf_range(-10.0, 10.0),
		generator.randf_range(-10.0, 10.0),
		generator.randf_range(-10.0, 10.0)
	)
	return make(
		translation, random_rotation(generator), exp(generator.randf_range(log(0.2), log(5.0)))
	)


static func random_rotation(generator: RandomNumberGenerator) -> Quaternion:
	while true:
		var four := Vector4(
			generator.randfn(), generator.randfn(), generator.randfn(), generator.randfn()
		)
		if four.length() > 0.01:
			four = four.normalized()
			return Quaternion(four.x, four.y, four.z, four.w)
	return Quaternion.IDENTITY
