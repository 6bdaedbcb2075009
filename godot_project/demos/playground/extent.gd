extends RefCounted
## Bounding boxes of objects, for framing them in the view.

const MOTIONS: Array[StringName] = [&"motor", &"rotor", &"translator", &"dilator"]
## Unbounded objects. The box of one of their points represents them.
const UNBOUNDED: Array[StringName] = [&"line", &"plane"]
## Half the size of the box around a point, in meters.
const POINT_RADIUS := 0.05


## The box around the entries; without volume if no entry has a position. Unbounded objects count
## only if there are no bounded ones.
static func of(scene: GAScene, entries: PackedStringArray) -> AABB:
	var bounded := AABB()
	var unbounded := AABB()
	for entry in entries:
		var value := scene.get_value(entry)
		if value == null:
			continue
		var facts := value.classify(scene.get_entry_attribute(entry, "ipns") as bool)
		var box := _box_of(value, facts)
		if facts["kind"] in UNBOUNDED:
			unbounded = _merge(unbounded, box)
		else:
			bounded = _merge(bounded, box)
	return bounded if bounded.has_volume() else unbounded


static func _box_of(value: Multivector, facts: Dictionary) -> AABB:
	var radius: float = maxf(facts.get("radius", 0.0) as float, POINT_RADIUS)
	if facts.has("center"):
		return _box(facts["center"] as Vector3, radius)
	if facts["kind"] == &"plane":
		return _box((facts["normal"] as Vector3) * (facts["distance"] as float), radius)
	if facts["kind"] in MOTIONS:
		return _merge(
			_box(Vector3.ZERO, POINT_RADIUS), _box(value.to_transform().origin, POINT_RADIUS)
		)
	return AABB()


static func _box(center: Vector3, radius: float) -> AABB:
	var half := Vector3.ONE * radius
	return AABB(center - half, 2.0 * half) if center.is_finite() and is_finite(radius) else AABB()


static func _merge(box: AABB, other: AABB) -> AABB:
	if not box.has_volume():
		return other
	return box.merge(other) if other.has_volume() else box
