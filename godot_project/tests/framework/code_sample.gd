extends RefCounted
## Finds and checks GDScript samples of pages and of the class reference: each must compile, run to
## its end, and print what the comments after its print() calls state.

const FENCE := "```gdscript\n"
## Folders that are built, or that belong to others.
const LEFT_OUT: Array[String] = ["build", "dist", "godot-cpp"]
## `print(EXPRESSION) # TEXT`, where EXPRESSION must print TEXT.
const PRINT := "(?m)^(\\t*)print\\((.*)\\) # (.*)$"
const SCRIPT := """extends %s


var printed := PackedStringArray()


func run() -> bool:
%s
	return true
"""


## The folder of the checkout, which contains the project.
static func repository() -> String:
	return ProjectSettings.globalize_path("res://").trim_suffix("/").get_base_dir()


## Paths of all Markdown files below a folder of the checkout, relative to the checkout.
static func find_pages(folder := "") -> PackedStringArray:
	var pages := PackedStringArray()
	var path := repository().path_join(folder)
	for file in DirAccess.get_files_at(path):
		if file.ends_with(".md"):
			pages.append(folder.path_join(file))
	for name in DirAccess.get_directories_at(path):
		if not name.begins_with(".") and not name in LEFT_OUT:
			pages.append_array(find_pages(folder.path_join(name)))
	return pages


static func read_page(page: String) -> String:
	return FileAccess.get_file_as_string(repository().path_join(page))


## The samples of a page that have no file name.
static func samples_of_page(text: String) -> PackedStringArray:
	var samples := PackedStringArray()
	for part in text.split(FENCE).slice(1):
		samples.append(part.get_slice("```", 0).dedent())
	return samples


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
		(instance as Node).name = "Sample"
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
