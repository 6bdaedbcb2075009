@tool
extends "../chapter.gd"
## Pictures of the dock, docked and floating, in the editor's theme and scale. Those that have a
## reference are compared with it. The user arguments are --look=NAME, the prefix of the pictures'
## names, --pictures=FOLDER and --references=FOLDER.

const PictureComparison := preload("res://tests/pictures/picture_comparison.gd")

## One object of each kind, an error, a long expression and an imaginary object.
const ENTRIES: PackedStringArray = [
	"A",
	"point(0, 1, 0)",
	"pair",
	"point_pair(A, point(2, 1, 0))",
	"l",
	"line(A, e1)",
	"c",
	"circle(A, e3, k)",
	"p",
	"plane(e2, 1.5)",
	"s",
	"sphere(A, 2)",
	"m",
	"motor(2 e1, rotor(e3, deg(90)), 1)",
	"k",
	"1.5",
	"wrong",
	"meet(s, gone)",
	"long_name",
	"sandwich(m, meet(sphere(A, 2), plane(e2, 1.5))) + 0.25 (A ^ point(2, 1, 0) ^ einf)",
	"imaginary",
	"meet(s, plane(e2, 9))",
]
const HEIGHT := 760
const COLORS: Dictionary[String, String] = {
	"A": "#e8b339", "c": "#2fa84f", "p": "#c64fd8", "s": "#e05252"
}


func run() -> void:
	await _arrange()
	var look := argument("--look")
	await _take("%s_docked" % look)
	# A dock that was floating when the editor ended floats again.
	if window() == plugin.get_window():
		await choose_in_tab_menu("Make Floating")
	expect_true(window() != plugin.get_window(), "the dock floating")
	for width: int in [250, 600]:
		dock().get_window().size = Vector2i(width, HEIGHT)
		await settle(12)
		await _take("%s_%d" % [look, width])
		part("Entries").set(&"scroll_vertical", 10000)
		await settle()
		await _take("%s_%d_end" % [look, width])
		coefficients().expand()
		await settle()
		await _take("%s_%d_coefficients" % [look, width])
		coefficients().fold()
		await settle()
	await begin_with([])
	await settle()
	await _take("%s_empty" % look)
	dock().get_window().close_requested.emit()
	await settle()


func _arrange() -> void:
	await begin_with(ENTRIES)
	for entry in COLORS:
		scene().set_entry_attribute(entry, "color", COLORS[entry])
	scene().set_entry_attribute("p", "visible", false)
	scene().set_entry_attribute("l", "label", false)
	await settle()
	await select(["c"])
	part("Entries").set(&"scroll_vertical", 0)
	await settle()


func _take(title: String) -> void:
	var taken := await picture()
	var folder := argument("--pictures")
	if not folder.is_empty():
		expect(
			taken.save_png(folder.path_join("dock_%s.png" % title)),
			OK,
			"saving the picture %s" % title
		)
	var reference := argument("--references").path_join("dock_%s.png" % title)
	if FileAccess.file_exists(reference):
		var compared := PictureComparison.compare(taken, Image.load_from_file(reference))
		expect_true(compared.is_alike(), "%s: %s" % [title, compared.describe()])
