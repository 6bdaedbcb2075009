@tool
extends RefCounted
## How each interpolation mode is named, explained and coloured; indexed by MultivectorLerp.Mode.

const COUNT := 3
const TITLES: Array[String] = ["Linear", "Screw", "Separate"]
const LINES: Array[String] = [
	"Blends the coefficients of the two motors",
	"Turns about one axis; size changes evenly",
	"Position, rotation and scale, each on its own",
]
const COLORS: Array[Color] = [
	Color(1.0, 0.62, 0.26),
	Color(0.22, 0.83, 0.75),
	Color(0.72, 0.56, 1.0),
]
## Of the expression language.
const FUNCTIONS: Array[String] = ["interpolate_linear", "interpolate_screw", "interpolate_separate"]
