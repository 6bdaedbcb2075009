@tool
extends "../chapter.gd"
## The buttons that combine two selected entries.

const ENTRIES: PackedStringArray = [
	"A",
	"point(0, 0, 1)",
	"p",
	"plane(e2, 1)",
	"q",
	"plane(e1, 2)",
	"s",
	"sphere(point(0, 0, 0), 2)",
	"d",
	"!sphere(point(0, 0, 0), 2)",
	"l",
	"line(point(0, 2, 0), e1 + e2)",
	"n",
	"!plane(e2, 1)",
	"m",
	"translator(3 e1)",
]
## Two entries, the button, and the name, expression and description of the added entry.
const CASES: Array[PackedStringArray] = [
	["p", "q", "meet", "l1", "meet(p, q)", "line, at (2, 1, 0), direction (0, 0, 1)"],
	[
		"p",
		"d",
		"intersect",
		"c1",
		"meet(p, undual(d))",
		"circle, radius 1.73205, center (0, 1, 0), normal (0, -1, 0)"
	],
	[
		"p",
		"s",
		"intersect",
		"c1",
		"meet(p, s)",
		"circle, radius 1.73205, center (0, 1, 0), normal (0, -1, 0)"
	],
	["A", "p", "project", "B", "project_onto(A ^ einf, p)", "flat point, at (0, 1, 1)"],
	["A", "n", "project", "B", "project_onto(A ^ einf, undual(n))", "flat point, at (0, 1, 1)"],
	["l", "p", "project", "l1", "project_onto(l, p)", "line, at (0, 1, 0), direction (1, 0, 0)"],
	["A", "q", "reflect", "B", "reflect_in(A, q)", "point, at (4, 0, 1)"],
	["m", "A", "move", "B", "sandwich(m, A)", "point, at (3, 0, 1)"],
	["d", "m", "move", "s1", "sandwich(m, d)", "dual sphere, radius 2, center (3, 0, 0)"],
]


func run() -> void:
	await begin_with(ENTRIES)
	for dual: String in ["d", "n"]:
		scene().set_entry_attribute(dual, "ipns", true)
	for case in CASES:
		await _combine(case)
	await select(["p", "q"])
	expect((part("Combinations/move") as Button).disabled, true, "Move for two planes")
	await select(["p"])
	for button: Button in part("Combinations").get_children():
		expect(button.disabled, true, "%s with one entry selected" % button.name)


func _combine(case: PackedStringArray) -> void:
	var before := scene().document
	await select(case.slice(0, 2))
	Hands.click(part("Combinations/" + case[2]))
	await settle(2)
	var what := "%s of %s and %s" % [case[2], case[0], case[1]]
	expect(names()[-1], case[3], "name of the " + what)
	expect(scene().get_expression(names()[-1]), case[4], "expression of the " + what)
	expect(words_of(names()[-1]), case[5], "description of the " + what)
	undo()
	expect(scene().document, before, "document after undoing the " + what)
