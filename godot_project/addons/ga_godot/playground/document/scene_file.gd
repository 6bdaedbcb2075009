@tool
extends RefCounted
## Reads scenes from JSON files.

## The largest file that is read, in bytes: no scene is larger.
const MAX_LENGTH := 16 << 20


## Returns why nothing could be loaded, or an empty string. What could not be read of a damaged file
## is in the scene's get_load_errors().
static func load_json(path: String, scene: GAScene) -> String:
	var file := FileAccess.open(path, FileAccess.READ)
	if file == null:
		return "%s cannot be read: %s." % [path, error_string(FileAccess.get_open_error())]
	if file.get_length() > MAX_LENGTH:
		return (
			"%s is too large for a playground scene: it has %d bytes, and at most %d are accepted."
			% [path, file.get_length(), MAX_LENGTH]
		)
	if scene.load_json_utf8(file.get_buffer(file.get_length())) == ERR_PARSE_ERROR:
		return "%s is not a playground scene:\n%s" % [path, "\n".join(scene.get_load_errors())]
	return ""
