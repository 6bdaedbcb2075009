extends RefCounted
## What a benchmark says: rows of JSON, to a file or as a line of output.


## The exit code of the run. Without a path the rows are printed.
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
