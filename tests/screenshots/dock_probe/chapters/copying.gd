@tool
extends "../chapter.gd"
## Copying entries as text in several formats, and pasting them.

const ENTRIES: PackedStringArray = [
	"A",
	"point(1, 2, 3)",
	"for",
	"sphere(A, 2)",
	"p",
	"plane(e2, 1.5)",
	"c_1",
	"meet(for, p)",
	"m",
	"motor(2 e1, rotor(e3, deg(90)), 1)",
]
# gdlint: disable=max-line-length
const LATEX := """\\begin{align*}
A &= \\mathbf{e}_{1} + 2 \\mathbf{e}_{2} + 3 \\mathbf{e}_{3} + 6.5 \\mathbf{e}_{4} + 7.5 \\mathbf{e}_{5} \\\\
p &= 1.5 \\mathbf{e}_{1234} + 1.5 \\mathbf{e}_{1235} + \\mathbf{e}_{1345}
\\end{align*}
"""
# gdlint: enable=max-line-length
## Compiled by tests/playground.
const CPP_FIXTURE := "res://addons/dock_probe/copied.inc"


func run() -> void:
	await begin_with(ENTRIES)
	await _copy_gdscript()
	await _copy_cpp()
	await _copy_latex()
	await _copy_numbers()
	await _paste()
	await _copy_json()


## The copied text is a script whose variables have the values of the entries.
func _copy_gdscript() -> void:
	await select(["c_1", "m"])
	await choose_for_entry("m", "Copy as GDScript")
	var script := GDScript.new()
	script.source_code = "extends RefCounted\n\n" + DisplayServer.clipboard_get()
	expect(script.reload(), OK, "compiling what was copied: %s" % script.source_code)
	var copied: RefCounted = script.new()
	for entry: String in ["A", "for", "p", "c_1", "m"]:
		var value: Multivector = copied.get("for_" if entry == "for" else entry)
		expect(
			value.coefficients if value != null else PackedFloat64Array(),
			scene().get_value(entry).coefficients,
			"%s copied as GDScript" % entry
		)
		expect(
			value.to_json() if value != null else "",
			scene().get_value(entry).to_json(),
			"%s copied as GDScript, to its last bit" % entry
		)


func _copy_cpp() -> void:
	await select(["A", "for", "c_1", "m"])
	await choose_for_entry("m", "Copy as C++")
	var place := argument("--copied-cpp")
	if not place.is_empty():
		FileAccess.open(place, FileAccess.WRITE).store_string(DisplayServer.clipboard_get())
	expect(
		DisplayServer.clipboard_get(),
		FileAccess.get_file_as_string(CPP_FIXTURE),
		"text copied as C++"
	)


func _copy_latex() -> void:
	await select(["A", "p"])
	await choose_for_entry("p", "Copy as LaTeX")
	expect(DisplayServer.clipboard_get(), LATEX, "text copied as LaTeX")


func _copy_numbers() -> void:
	await select(["A"])
	await choose_for_entry("A", "Copy as 32 Numbers")
	expect(
		DisplayServer.clipboard_get(),
		"[0,1,2,3,6.5,7.5%s]" % ",0".repeat(26),
		"text copied as 32 numbers"
	)


func _paste() -> void:
	var before := scene().document
	await choose_in_file_menu("Paste JSON or 32 Numbers")
	expect(names()[-1], "B", "name of a point pasted as 32 numbers")
	expect(words_of("B"), "point, at (1, 2, 3)", "description of 32 pasted numbers")
	undo()
	expect(scene().document, before, "document after undoing a paste")
	DisplayServer.clipboard_set("neither")
	await choose_in_file_menu("Paste JSON or 32 Numbers")
	expect(scene().document, before, "document after pasting invalid text")


func _copy_json() -> void:
	var before := scene().document
	await choose_in_file_menu("Copy JSON")
	expect(DisplayServer.clipboard_get(), before, "the copied document")
	Hands.click(part("Objects/point"))
	await settle(2)
	await choose_in_file_menu("Paste JSON or 32 Numbers")
	expect(scene().document, before, "document after pasting a whole one")
	undo()
	expect(names().size(), 6, "entries after undoing that")
