extends "res://tests/framework/test_case.gd"
## Files that the addon and the examples write: complete, or as they were before.

const FullDisk := preload("res://tests/framework/full_disk.gd")
const SafeFile := preload("res://addons/ga_godot/playground/document/safe_file.gd")
const SceneFile := preload("res://addons/ga_godot/playground/document/scene_file.gd")

const FOLDER := FullDisk.FOLDER
const SAVED := "saved before"
## The largest file that the engine in _save_with_full_disk() can write, in blocks of 512 bytes.
const BLOCKS := 4


func _init() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)


func test_a_full_disk_loses_nothing_that_was_saved() -> void:
	var names: Array[String] = [
		"config", "json", "motion", "picture.png", "scene.tres", "screenshot.png", "short"
	]
	for name in names:
		_put(name, SAVED)
	var outcomes := _save_with_full_disk()
	expect_equal(outcomes.get("json"), float(ERR_FILE_CANT_WRITE), "saving a long file")
	expect_equal(outcomes.get("short"), float(ERR_FILE_CANT_WRITE), "saving a short file")
	expect_equal(outcomes.get("config"), float(ERR_FILE_CANT_WRITE), "saving settings")
	expect_equal(outcomes.get("scene.tres"), float(ERR_CANT_CREATE), "saving a resource")
	expect_equal(
		outcomes.get("picture.png"),
		(
			"%s cannot be written completely. Check the free space on the disk."
			% FOLDER.path_join("picture.png")
		),
		"saving a picture"
	)
	expect_equal(outcomes.get("screenshot.png"), float(ERR_FILE_CANT_WRITE), "a screenshot")
	expect_equal(outcomes.get("motion"), [0.0, float(ERR_FILE_CANT_WRITE)], "recording")
	for name in names:
		expect_equal(_content(name), SAVED, name)
	expect_equal(_files(), PackedStringArray(names), "the files in the folder")
	_remove_all()


func test_what_is_saved_is_complete() -> void:
	_put("a", "old")
	FileAccess.set_unix_permissions(
		FOLDER.path_join("a"), FileAccess.UNIX_READ_OWNER | FileAccess.UNIX_WRITE_OWNER
	)
	expect_equal(SafeFile.write(FOLDER.path_join("a"), "new".to_utf8_buffer()), OK, "writing")
	expect_equal(_content("a"), "new", "the file")
	expect_equal(
		int(FileAccess.get_unix_permissions(FOLDER.path_join("a"))),
		int(FileAccess.UNIX_READ_OWNER | FileAccess.UNIX_WRITE_OWNER),
		"permissions"
	)
	expect_equal(
		SafeFile.write(FOLDER.path_join("empty"), PackedByteArray()), OK, "writing nothing"
	)
	DirAccess.open(FOLDER).create_link("a", "link")
	expect_equal(SafeFile.write(FOLDER.path_join("link"), "linked".to_utf8_buffer()), OK, "writing")
	expect_true(DirAccess.open(FOLDER).is_link("link"), "the link is still one")
	expect_equal(_content("a"), "linked", "the file that the link leads to")
	expect_equal(
		SafeFile.write(FOLDER.path_join("no/folder"), PackedByteArray()),
		ERR_FILE_NOT_FOUND,
		"writing into a folder that does not exist"
	)
	expect_equal(_files(), PackedStringArray(["a", "empty", "link"]), "the files in the folder")
	_remove_all()


func test_a_resource_keeps_its_path_and_its_text() -> void:
	var path := FOLDER.path_join("scene.tres")
	for note: String in ["", 'two\nlines "quoted" \\ ä']:
		var scene := GAScene.new()
		if not note.is_empty():
			scene.set_scene_attribute("note", note)
		expect_equal(SafeFile.save_resource(path, scene), OK, "saving")
		expect_equal(scene.resource_path, path, "path")
		var loaded := ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE) as GAScene
		expect_equal(loaded.document, scene.document, "text")
	expect_equal(_files(), PackedStringArray(["scene.tres"]), "the files in the folder")
	_remove_all()


func test_a_file_that_was_cut_short_keeps_its_complete_entries() -> void:
	var scene := GAScene.new()
	for index in 20:
		scene.add_entry("a%d" % index, "%d" % index)
	var text := scene.to_json()
	for count: int in [1, 7, 20]:
		var size := text.find("}", text.find('"a%d"' % (count - 1))) + 1
		var file := FileAccess.open(FOLDER.path_join("cut"), FileAccess.WRITE)
		file.store_string(text.left(size))
		file.close()
		var place := (
			"line %d, column %d: expected ',' or ']', found the end"
			% [4 + count, size - text.rfind("\n", size - 1)]
		)
		expect_error(
			(
				"GAScene.load_json_utf8: parts of the text could not be read; the rest was loaded:"
				+ "\n%s." % place
			)
		)
		var read := GAScene.new()
		expect_equal(SceneFile.load_json(FOLDER.path_join("cut"), read), "", "loading")
		expect_equal(read.get_names(), scene.get_names().slice(0, count), "entries")
		expect_equal(read.get_load_errors(), PackedStringArray([place]), "errors")
	_remove_all()


func test_a_file_that_is_too_large_is_not_read() -> void:
	var path := FOLDER.path_join("large")
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.seek(SceneFile.MAX_LENGTH)
	file.store_8(32)
	file.close()
	expect_equal(
		SceneFile.load_json(path, GAScene.new()),
		(
			(
				"%s is too large for a playground scene: it has 16777217 bytes, and at most"
				+ " 16777216 are accepted."
			)
			% path
		),
		"loading"
	)
	_remove_all()


func _save_with_full_disk() -> Dictionary:
	# A process that ignores the signal of a file that became too large gets an error instead.
	var command := (
		"trap '' XFSZ; ulimit -f %d; exec '%s' --headless --path '%s' --script %s"
		% [
			BLOCKS,
			Emulation.get_engine_path(),
			ProjectSettings.globalize_path("res://"),
			(FullDisk as Script).resource_path
		]
	)
	var output := []
	OS.execute("sh", ["-c", command], output, true)
	for line: String in (output[0] as String).split("\n"):
		if line.begins_with(FullDisk.MARK):
			return JSON.parse_string(line.trim_prefix(FullDisk.MARK))
	fail("no outcomes:\n%s" % output[0])
	return {}


func _put(name: String, text: String) -> void:
	var file := FileAccess.open(FOLDER.path_join(name), FileAccess.WRITE)
	file.store_string(text)
	file.close()


func _content(name: String) -> String:
	return FileAccess.get_file_as_string(FOLDER.path_join(name))


func _files() -> PackedStringArray:
	var names := DirAccess.get_files_at(FOLDER)
	names.sort()
	return names


func _remove_all() -> void:
	for name in _files():
		DirAccess.remove_absolute(FOLDER.path_join(name))
