@tool
extends RefCounted
## Poses and deviations as text.

## Smaller distances (meters) and angles (radians) are not shown.
const EPSILON := 1e-6


## "at (1.00, 2.00, 3.00), rotated 45.0° about (0.00, 0.00, 1.00), scale 2.00". Decimals are fixed,
## so that the text does not jump while t moves.
static func pose(motor: Multivector) -> String:
	var position := motor.get_translation()
	var words := PackedStringArray(
		["at %s" % _vector(position, 2 if position.length() >= 1.0 else 3)]
	)
	var rotation := motor.get_rotation()
	if rotation.w < 0.0:
		rotation = -rotation
	var sines := Vector3(rotation.x, rotation.y, rotation.z)
	if sines.length() > EPSILON:
		words.append(
			(
				"rotated %s° about %s"
				% [
					_number(rad_to_deg(2.0 * atan2(sines.length(), rotation.w)), 1),
					_vector(sines.normalized(), 2)
				]
			)
		)
	if absf(motor.get_scale() - 1.0) > EPSILON:
		words.append("scale %s" % _number(motor.get_scale(), 2 if motor.get_scale() >= 0.1 else 4))
	return ", ".join(words)


## Describes a result of MultivectorLerp.measure_deviation().
static func deviation(found: Dictionary) -> String:
	var parts := PackedStringArray()
	if found["distance"] > EPSILON:
		parts.append(
			"%s (t = %.2f)" % [length(found["distance"] as float), found["distance_weight"]]
		)
	if found["angle"] > EPSILON:
		parts.append("%s (t = %.2f)" % [angle(found["angle"] as float), found["angle_weight"]])
	return "no deviation from screw" if parts.is_empty() else "deviation: %s" % ", ".join(parts)


static func length(meters: float) -> String:
	if meters >= 1.0:
		return "%.2f m" % meters
	return (
		"%s mm"
		% String.num(meters * 1000.0, 3 if meters < 1e-3 else 1 if meters < 0.1 else 0).trim_suffix(
			".0"
		)
	)


static func angle(radians: float) -> String:
	var degrees := rad_to_deg(radians)
	return "%s°" % String.num(degrees, 4 if degrees < 0.1 else 2 if degrees < 10.0 else 1)


static func _vector(vector: Vector3, decimals: int) -> String:
	return (
		"(%s, %s, %s)"
		% [_number(vector.x, decimals), _number(vector.y, decimals), _number(vector.z, decimals)]
	)


# Adding 0.0 turns -0.0 into 0.0.
static func _number(number: float, decimals: int) -> String:
	return String.num(snappedf(number, pow(10.0, -decimals)) + 0.0, decimals).pad_decimals(decimals)
