@tool
extends RefCounted
## Writes files without ever leaving a cut one: writes a temporary file beside, checks that it is
## complete, and renames it. After an error, such as a full disk, the old file is unchanged and the
## temporary file is removed.

## What a file with this suffix is: one that a crash left behind.
const SUFFIX := ".part"


static func write(path: String, bytes: PackedByteArray) -> Error:
	var target := _followed(path)
	var store := func(temporary: String) -> Error: return _store(temporary, bytes)
	return _replace(target, target + SUFFIX, store)


static func save_config(path: String, config: ConfigFile) -> Error:
	return write(path, config.encode_to_text().to_utf8_buffer())


## Saves a scene as a resource, and gives it this path.
static func save_resource(path: String, scene: GAScene) -> Error:
	var target := _followed(path)
	var temporary := "%s%s.%s" % [target.get_basename(), SUFFIX, target.get_extension()]
	var store := func(to: String) -> Error: return _store_resource(to, path, scene)
	var outcome := _replace(target, temporary, store)
	if outcome == OK:
		scene.take_over_path(path)
	return outcome


## Sets the UID in the first line of a resource file, as ResourceSaver.set_uid from Godot 4.5.
static func set_uid(path: String, id: int) -> Error:
	var text := FileAccess.get_file_as_string(path)
	var header := text.get_slice("\n", 0)
	var pattern := RegEx.create_from_string(' uid="[^"]*"')
	var new_header := pattern.sub(header, "").trim_suffix("]")
	new_header += ' uid="%s"]' % ResourceUID.id_to_text(id)
	return _store(path, (new_header + text.substr(header.length())).to_utf8_buffer())


# Calls `store` with the path of the temporary file, then renames that file to `path`. `store`
# returns an error unless the file is complete.
static func _replace(path: String, temporary: String, store: Callable) -> Error:
	var exists := FileAccess.file_exists(path)
	if exists and FileAccess.open(path, FileAccess.READ_WRITE) == null:
		return FileAccess.get_open_error()
	var outcome: Error = store.call(temporary)
	if outcome == OK and exists:
		FileAccess.set_unix_permissions(temporary, FileAccess.get_unix_permissions(path))
	if outcome == OK:
		outcome = DirAccess.rename_absolute(temporary, path)
	if outcome != OK and FileAccess.file_exists(temporary):
		DirAccess.remove_absolute(temporary)
	return outcome


# The file that a symbolic link leads to, so that the link stays.
static func _followed(path: String) -> String:
	var folder := DirAccess.open(path.get_base_dir())
	if folder == null or not folder.is_link(path):
		return path
	var target := folder.read_link(path)
	return target if target.is_absolute_path() else path.get_base_dir().path_join(target)


# Closing writes what is buffered, and reports no error: the length tells whether all was written.
static func _store(path: String, bytes: PackedByteArray) -> Error:
	var file := FileAccess.open(path, FileAccess.WRITE)
	if file == null:
		return FileAccess.get_open_error()
	file.store_buffer(bytes)
	file.close()
	file = FileAccess.open(path, FileAccess.READ)
	return OK if file != null and file.get_length() == bytes.size() else ERR_FILE_CANT_WRITE


static func _store_resource(path: String, final_path: String, scene: GAScene) -> Error:
	var id := ResourceLoader.get_resource_uid(final_path)
	var outcome := ResourceSaver.save(scene, path)
	if outcome != OK:
		return outcome
	if id != ResourceUID.INVALID_ID:
		outcome = set_uid(path, id)
		if outcome != OK:
			return outcome
	var text := FileAccess.get_file_as_string(path)
	var is_complete := text.ends_with("\n") and text.contains(var_to_str(scene.document) + "\n")
	return OK if is_complete or scene.document.is_empty() else ERR_FILE_CANT_WRITE
