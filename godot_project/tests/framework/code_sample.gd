extends RefCounted
## Checks a GDScript sample of a guide or of the class reference: it must compile, run to its end,
## and print what the comments after its print() calls state.

## `print(EXPRESSION) # TEXT`, where EXPRESSION must print TEXT.
const PRINT := "(?m)^(\\t*)print\\((.*)\\) # (.*)$"
const SCRIPT := """extends %s


var printed := PackedStringArray()


func run() -> bool:
%s
	return true
"""


## The number of print() calls with such a comment.
static func count_prints(sample: String) -> int:
	return RegEx.create_from_string(PRINT).search_all(sample).size()


## Describes what is wrong with a sample. A failed assertion, or any other error, ends its run. With
## a [param parent], the sample runs in a child node of it, which is freed with its children.
static func find_faults(sample: String, parent: Node = null) -> PackedStringArray:
	var pattern := RegEx.create_from_string(PRINT)
	var script := GDScript.new()
	var base := "RefCounted" if parent == null else "Node"
	script.source_code = (
		SCRIPT % [base, pattern.sub(sample, "$1printed.append(str($2))", true).indent("\t")]
	)
	if script.reload() != OK:
		return ["does not compile:\n%s" % sample]
	var instance: Object = script.new()
	if parent != null:
		parent.add_child(instance as Node)
	var ended: bool = instance.call(&"run") == true
	var printed: PackedStringArray = instance.get(&"printed")
	if parent != null:
		instance.free()
	if not ended:
		return ["does not run to its end:\n%s" % sample]
	var faults := PackedStringArray()
	var calls := pattern.search_all(sample)
	for i in calls.size():
		var text := printed[i] if i < printed.size() else "nothing"
		if text != calls[i].get_string(3):
			faults.append("prints %s instead of %s" % [text, calls[i].get_string().strip_edges()])
	return faults
