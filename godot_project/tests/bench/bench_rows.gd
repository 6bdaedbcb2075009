extends RefCounted
## The output of a benchmark: rows of JSON in a file, or on one line of standard output.


## Writes the rows to a file, or prints them if [param path] is empty. Returns the exit code.
static func write(rows: Array[Dictionary], path: String) -> int:
	var text := JSON.stringify({"rows": rows})
	if path.is_empty():
		print(text)
		return 0
	var file := FileAccess.open(path, FileAccess.WRITE)
	if file == null:
		printerr("cannot write %s: %s" % [path, error_string(FileAccess.get_open_error())])
		return 1
	file.store_string(text)
	file.close()
	return 0
