@tool
extends RefCounted
## Titles, descriptions and colors of the interpolation modes, indexed by MultivectorLerp.Mode.

const COUNT := 3
const TITLES: Array[String] = ["Linear", "Screw", "Separate"]
const DESCRIPTIONS: Array[String] = [
	"Blends the coefficients of the two motors",
	"Rotates about one axis; scales geometrically",
	"Treats position, rotation, scale separately",
]
const COLORS: Array[Color] = [
	Color(1.0, 0.62, 0.26),
	Color(0.22, 0.83, 0.75),
	Color(0.72, 0.56, 1.0),
]
## Functions in expressions.
const FUNCTIONS: Array[String] = ["interpolate_linear", "interpolate_screw", "interpolate_separate"]
