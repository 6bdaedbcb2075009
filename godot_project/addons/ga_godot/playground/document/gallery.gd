@tool
extends RefCounted
## The examples in the addon, in the recommended order.

const FOLDER := "res://addons/ga_godot/gallery"

## Titles by file name without extension.
const EXAMPLES: Dictionary[String, String] = {
	"circle_through_points": "Circle through three points",
	"sphere_through_points": "Sphere through four points",
	"join_and_meet": "Join and meet",
	"sphere_and_plane": "Sphere and plane: real, tangent, imaginary",
	"three_spheres": "Two spheres, three spheres",
	"reflection": "Reflection in a plane",
	"inversion": "Inversion in a sphere",
	"turn_by_two_mirrors": "A rotation is two reflections",
	"shift_by_two_mirrors": "A translation is two parallel reflections",
	"cube_between_poses": "A cube between two poses",
	"blending_methods": "Three paths between two poses",
	"shell": "A motion that rotates and scales",
	"loxodrome": "From pole to pole",
	"robot_arm": "A robot arm",
	"two_pencils": "Two pencils",
	"apollonius": "The problem of Apollonius",
	"hexlet": "Soddy's hexlet",
	"hopf_circles": "Villarceau and Hopf circles",
}
## Section titles by the first example of the section.
const SECTIONS: Dictionary[String, String] = {
	"circle_through_points": "Objects",
	"reflection": "Reflections",
	"cube_between_poses": "Motions",
	"robot_arm": "Problems and curiosities",
}


static func list() -> PackedStringArray:
	return PackedStringArray(EXAMPLES.keys())


static func path_of(example: String) -> String:
	return FOLDER.path_join(example + ".json")


## Returns a new copy of the example, or null if it cannot be opened; see error_of().
static func load_example(example: String) -> GAScene:
	if not error_of(example).is_empty():
		return null
	var scene := GAScene.new()
	return scene if scene.load_json(FileAccess.get_file_as_string(path_of(example))) == OK else null


## Returns why the example cannot be opened, or an empty string.
static func error_of(example: String) -> String:
	if not EXAMPLES.has(example):
		return 'There is no example named "%s".' % example
	if not FileAccess.file_exists(path_of(example)):
		return (
			(
				"%s is missing. Copy the complete addons/ga_godot folder, or export the project with"
				+ " *.json files."
			)
			% path_of(example)
		)
	return ""
