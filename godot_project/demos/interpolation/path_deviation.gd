extends RefCounted
## How far the paths of two interpolation modes lie apart.

const PathDeviation := preload("res://demos/interpolation/path_deviation.gd")

const SAMPLES := 101

## Distance between the centres, in millimetres.
var distance_mm := 0.0
## Angle between the rotations, in degrees.
var angle_degrees := 0.0


## The deviation at one weight.
static func at(from: Transform3D, to: Transform3D, weight: float, first: MultivectorLerp.Mode, second: MultivectorLerp.Mode) -> PathDeviation:
	var a := MultivectorLerp.interpolate_transform(from, to, weight, first)
	var b := MultivectorLerp.interpolate_transform(from, to, weight, second)
	var result := PathDeviation.new()
	result.distance_mm = a.origin.distance_to(b.origin) * 1000.0
	result.angle_degrees = _angle(a.basis, b.basis)
	return result


## The largest distance and the largest angle over the whole path.
static func largest(from: Transform3D, to: Transform3D, first: MultivectorLerp.Mode, second: MultivectorLerp.Mode) -> PathDeviation:
	var result := PathDeviation.new()
	for i in SAMPLES:
		var here := at(from, to, float(i) / (SAMPLES - 1), first, second)
		result.distance_mm = maxf(result.distance_mm, here.distance_mm)
		result.angle_degrees = maxf(result.angle_degrees, here.angle_degrees)
	return result


## By the arctangent: the arccosine loses everything below 0.03 degrees in single precision.
static func _angle(a: Basis, b: Basis) -> float:
	var turn := a.get_rotation_quaternion().inverse() * b.get_rotation_quaternion()
	return rad_to_deg(2.0 * atan2(Vector3(turn.x, turn.y, turn.z).length(), absf(turn.w)))
