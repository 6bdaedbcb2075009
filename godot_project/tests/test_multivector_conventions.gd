extends "res://tests/framework/test_case.gd"
## docs/conventions.md: its statements about signs and other libraries hold, and each row of its
## table of formulas refers to code and to a test that exist.

const PAGE := "docs/conventions.md"
const TABLE := "| formula | computed in | tested by |"
## A path, then a string that the file contains: `path` `name` or `path` "name".
const REFERENCE := '`([a-z0-9_/]+\\.[a-z]+)` (?:`([^`]+)`|"([^"]+)")'

const ELEMENT: Array[float] = [
	1.5,
	-2,
	0,
	3,
	0.5,
	-1,
	2,
	0,
	0,
	1,
	-1,
	0,
	0,
	0.25,
	0,
	4,
	0,
	-3,
	0,
	1,
	0,
	0,
	0,
	0,
	2,
	0,
	0,
	0,
	1,
	-1,
	0,
	0.5
]


func test_every_formula_refers_to_its_code_and_its_test() -> void:
	var rows := _page().get_slice(TABLE, 1).strip_edges().split("\n").slice(1)
	expect_true(rows.size() >= 25, "number of formulas")
	var pattern := RegEx.create_from_string(REFERENCE)
	for row in rows:
		var cells := row.split("|")
		for cell: String in [cells[cells.size() - 3], cells[cells.size() - 2]]:
			var references := pattern.search_all(cell)
			expect_true(references.size() > 0, 'a reference in "%s"' % cell)
			for reference in references:
				var text := FileAccess.get_file_as_string(
					_repository().path_join(reference.get_string(1))
				)
				var wanted := reference.get_string(2) + reference.get_string(3)
				expect_true(text.contains(wanted), '"%s" in %s' % [wanted, reference.get_string(1)])


func test_the_order_of_coefficients() -> void:
	var index := 0
	for line in _page().get_slice("| index | blades |", 1).get_slice("\n\n", 0).split("\n").slice(
		2
	):
		for name in line.get_slice("|", 2).strip_edges().split(" "):
			expect_coefficients(Multivector.basis(name), {index: 1.0}, 0.0, name)
			index += 1
	expect_equal(index, 32, "number of blades")


func test_ganja_has_the_same_coefficients_and_the_other_dual() -> void:
	var a := Multivector.from_json(JSON.stringify(ELEMENT))
	var ganja_dual := a.geometric_product(Multivector.basis("I"))
	expect_coefficients(a.undual().subtract(ganja_dual), {}, 0.0, "undual here less dual there")
	expect_coefficients(a.dual().add(ganja_dual), {}, 0.0, "dual here plus dual there")
	# ganja.js: e123 & e145 is e1, e12345 & e1 is e1, e2345 & e1234 is e234.
	expect_coefficients(_regressive("e123", "e145"), {1: 1.0}, 0.0)
	expect_coefficients(_regressive("I", "e1"), {1: 1.0}, 0.0)
	expect_coefficients(_regressive("e2345", "e1234"), {22: 1.0}, 0.0)


func test_handedness() -> void:
	# x to y about z, y to z about x, z to x about y; and the same by the engine's quaternions.
	var axes: Array[Vector3] = [Vector3.RIGHT, Vector3.UP, Vector3.BACK]
	for i in 3:
		var quarter := Quaternion(axes[i], PI / 2.0)
		var turned := Multivector.rotor(quarter).transform_point(axes[(i + 1) % 3])
		expect_vector_near(turned, axes[(i + 2) % 3], 1e-6)
		expect_vector_near(turned, quarter * axes[(i + 1) % 3], 1e-6)


func test_the_papers_dilator_is_the_same() -> void:
	for scale: float in [0.25, 1.0, 3.0]:
		var papers := Multivector.scalar(1.0).add(
			Multivector.basis("E").scaled((1.0 - scale) / (1.0 + scale))
		)
		expect_near(papers.get_scale(), scale, 1e-12, "scale")
		expect_true(
			papers.normalized().is_equal_approx(Multivector.dilator(scale)),
			"equality after normalization at scale %s" % scale
		)


func _regressive(left: String, right: String) -> Multivector:
	return Multivector.basis(left).regressive_product(Multivector.basis(right))


func _page() -> String:
	var text := FileAccess.get_file_as_string(_repository().path_join(PAGE))
	expect_true(not text.is_empty(), "text in %s" % PAGE)
	return text


func _repository() -> String:
	return ProjectSettings.globalize_path("res://").trim_suffix("/").get_base_dir()
