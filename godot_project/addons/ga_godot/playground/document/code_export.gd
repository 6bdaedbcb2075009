@tool
extends RefCounted
## Exports entries as GDScript, C++ and LaTeX.

## Keywords of GDScript and C++, which cannot be names of variables.
const RESERVED: PackedStringArray = [
	"and",
	"as",
	"assert",
	"auto",
	"await",
	"bool",
	"break",
	"case",
	"catch",
	"char",
	"class",
	"const",
	"continue",
	"default",
	"delete",
	"do",
	"double",
	"elif",
	"else",
	"enum",
	"export",
	"extends",
	"extern",
	"false",
	"float",
	"for",
	"func",
	"goto",
	"if",
	"in",
	"int",
	"is",
	"long",
	"match",
	"namespace",
	"new",
	"not",
	"null",
	"operator",
	"or",
	"pass",
	"preload",
	"private",
	"public",
	"return",
	"self",
	"short",
	"signal",
	"static",
	"struct",
	"super",
	"switch",
	"template",
	"this",
	"throw",
	"true",
	"try",
	"typename",
	"union",
	"using",
	"var",
	"void",
	"when",
	"while",
	"yield",
]


static func gdscript(scene: GAScene, entries: PackedStringArray) -> String:
	var lines := PackedStringArray()
	for entry in _in_order(scene, entries):
		var variables := PackedStringArray()
		for dependency in scene.get_dependencies(entry):
			variables.append("%s: %s" % [JSON.stringify(dependency), _variable(dependency)])
		var given := ", {%s}" % ", ".join(variables) if not variables.is_empty() else ""
		lines.append(
			(
				'var %s := Multivector.evaluate("%s"%s)'
				% [_variable(entry), scene.get_expression(entry).c_escape(), given]
			)
		)
	return "\n".join(lines) + "\n"


## The values as constants of type cga::Multivector (cga/algebra/multivector.hpp).
static func cpp(scene: GAScene, entries: PackedStringArray) -> String:
	var lines := PackedStringArray()
	for entry in entries:
		var value := scene.get_value(entry)
		if value != null:
			lines.append("// %s = %s" % [entry, scene.get_expression(entry).replace("\n", " ")])
			lines.append(
				(
					"const cga::Multivector %s({ %s });"
					% [
						_variable(entry),
						value.to_json().trim_prefix("[").trim_suffix("]").replace(",", ", ")
					]
				)
			)
	return "\n".join(lines) + "\n"


static func latex(scene: GAScene, entries: PackedStringArray) -> String:
	var lines := PackedStringArray()
	for entry in entries:
		var value := scene.get_value(entry)
		if value != null:
			lines.append("%s &= %s" % [_latex_name(entry), value.to_latex()])
	return "\\begin{align*}\n%s\n\\end{align*}\n" % " \\\\\n".join(lines)


static func _latex_name(entry: String) -> String:
	return entry if entry.length() == 1 else "\\mathit{%s}" % entry.replace("_", "\\_")


static func _variable(entry: String) -> String:
	return entry + "_" if RESERVED.has(entry) else entry


## Returns the entries and their dependencies, dependencies first, without entries that have an
## error.
static func _in_order(scene: GAScene, entries: PackedStringArray) -> PackedStringArray:
	var order := PackedStringArray()
	# Whether an entry is in `order`; false while its dependencies are not.
	var is_placed: Dictionary[String, bool] = {}
	var open := entries.duplicate()
	open.reverse()
	while not open.is_empty():
		var entry := open[-1]
		if not is_placed.has(entry) and scene.get_value(entry) != null:
			is_placed[entry] = false
			var dependencies := scene.get_dependencies(entry)
			dependencies.reverse()
			open.append_array(dependencies)
			continue
		open.remove_at(open.size() - 1)
		if not is_placed.get(entry, true):
			is_placed[entry] = true
			order.append(entry)
	return order
