extends RefCounted
## Which tests the argument of the runner selects: those whose file or method name contains it, or
## the one test "FILE METHOD"; all if it is empty. It may be several, separated by commas.


static func selects(argument: String, file: String, method_name: String) -> bool:
	if argument.is_empty():
		return true
	for name in argument.split(","):
		var title := "%s %s" % [file.trim_suffix(".gd"), method_name]
		if file.contains(name) or method_name.contains(name) or title == name:
			return true
	return false


## False if the file need not be loaded, because the argument names other files alone.
static func may_select_from(argument: String, file: String) -> bool:
	for name in argument.split(","):
		if not name.ends_with(".gd") or file.contains(name):
			return true
	return false
