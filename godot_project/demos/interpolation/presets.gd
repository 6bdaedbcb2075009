extends RefCounted
## Pairs of poses that show where the interpolation modes agree and where they differ.

const DemoPose := preload("res://demos/interpolation/demo_pose.gd")
const Preset := preload("res://demos/interpolation/presets.gd")

var title: String
## What to look for, in one sentence.
var hint: String
var start: DemoPose
var end: DemoPose


func _init(p_title: String, p_hint: String, p_start: DemoPose, p_end: DemoPose) -> void:
	title = p_title
	hint = p_hint
	start = p_start
	end = p_end


static func list() -> Array[Preset]:
	return [
		Preset.new(
			"Rotate, Translate and Scale",
			"Scale 0.5 to 2.5: the screw path is a spiral that widens as the cube grows.",
			DemoPose.new(Vector3(-1.9, 0.45, 1.1), Vector3(0, -20, 0), 0.5),
			DemoPose.new(Vector3(1.9, 1.25, -0.6), Vector3(20, 115, 0), 2.5)
		),
		Preset.new(
			"Rotation by 180°",
			"At 180° the linear and screw paths differ most, by up to 8.2°.",
			DemoPose.new(Vector3(-1.8, 0.6, 0.6), Vector3(0, 0, 0), 1.8),
			DemoPose.new(Vector3(1.8, 0.6, 0.6), Vector3(0, 180, 0), 1.8)
		),
		Preset.new(
			"Door on Its Hinge",
			"Both motor paths keep the hinge fixed; the separate path cuts the corner.",
			DemoPose.new(Vector3(1.6, 0.6, 1.4), Vector3(0, 0, 0), 1.8),
			DemoPose.new(Vector3(-1.2, 0.6, -1.4), Vector3(0, 90, 0), 1.8)
		),
		Preset.new(
			"Corkscrew",
			"Rotating while rising: a helix compared with a straight line.",
			DemoPose.new(Vector3(-1.4, 0.4, 0), Vector3(0, 0, 0), 1.4),
			DemoPose.new(Vector3(1.3, 2.2, 0.4), Vector3(0, 165, 0), 1.4)
		),
		(
			Preset
			. new(
				"Scaling Without Rotation",
				"No rotation: all paths are straight, but the steps of the screw path grow with the scale.",
				DemoPose.new(Vector3(-1.6, 0.4, 0), Vector3(0, 30, 0), 0.5),
				DemoPose.new(Vector3(1.8, 0.9, 0), Vector3(0, 30, 0), 2.5)
			)
		),
		Preset.new(
			"Translation Only",
			"Neither rotation nor scale: the three paths coincide.",
			DemoPose.new(Vector3(-1.7, 0.5, 0.8), Vector3(0, 30, 0), 1.4),
			DemoPose.new(Vector3(2.0, 1.0, -0.8), Vector3(0, 30, 0), 1.4)
		),
	]
