@tool
extends RefCounted
## New entries for each kind of object: titles, expressions and names.

const KINDS: Array[StringName] = [
	&"point", &"pair", &"line", &"circle", &"plane", &"sphere", &"motor", &"scalar"
]
const TITLES: Dictionary[StringName, String] = {
	&"point": "Point",
	&"pair": "Point Pair",
	&"line": "Line",
	&"circle": "Circle",
	&"plane": "Plane",
	&"sphere": "Sphere",
	&"motor": "Motor",
	&"scalar": "Number with Slider",
}
## %d is the number of existing entries of this kind, so that new ones do not coincide.
const EXPRESSIONS: Dictionary[StringName, String] = {
	&"point": "point(%d, 0, 0)",
	&"pair": "point_pair(point(%d, 0, 0), point(0, 1, 0))",
	&"line": "line(point(0, %d, 0), e1)",
	&"circle": "circle(point(%d, 0, 0), e3, 1)",
	&"plane": "plane(e2, %d)",
	&"sphere": "sphere(point(%d, 0, 0), 1)",
	&"motor": "motor(%d e1, rotor(e3, deg(90)), 1)",
	&"scalar": "%d",
}
## Prefixes of names by the kind that Multivector.classify() returns.
const PREFIXES: Dictionary[StringName, String] = {
	&"point_pair": "pair",
	&"line": "l",
	&"circle": "c",
	&"plane": "p",
	&"sphere": "s",
	&"motor": "m",
	&"rotor": "r",
	&"translator": "t",
	&"dilator": "d",
	&"scalar": "k",
	&"direction": "v",
	&"pair": "pair",
}
## Names of points. E and I are omitted, because they are constants in expressions.
const POINT_NAMES := "ABCDFGHJKLMNOPQRSTUVWXYZ"
## Kinds that can also be added as duals.
const WITH_DUAL: Array[StringName] = [&"point", &"pair", &"line", &"circle", &"plane", &"sphere"]


static func expression(kind: StringName, dual: bool, scene: GAScene) -> String:
	var text := (
		EXPRESSIONS[kind] % (_count(kind, scene) + (1 if kind in [&"motor", &"scalar"] else 0))
	)
	return "!" + text if is_dual(kind, dual) else text


static func is_dual(kind: StringName, dual: bool) -> bool:
	return dual and kind in WITH_DUAL


## An unused name: A, B, ... for points, otherwise a prefix and a number.
static func free_name(kind: StringName, scene: GAScene) -> String:
	if kind in [&"point", &"flat_point"]:
		for letter in POINT_NAMES:
			if not scene.has_entry(letter):
				return letter
	var prefix: String = PREFIXES.get(kind, "P" if kind == &"point" else "x")
	var number := 1
	while scene.has_entry("%s%d" % [prefix, number]):
		number += 1
	return "%s%d" % [prefix, number]


static func _count(kind: StringName, scene: GAScene) -> int:
	var count := 0
	for entry in scene.get_names():
		if scene.get_expression(entry).trim_prefix("!").begins_with(
			EXPRESSIONS[kind].get_slice("(", 0) + "("
		):
			count += 1
	return count
