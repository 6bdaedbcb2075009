extends SceneTree
## Saves one file of each kind and ends. test_safe_file.gd runs it in an engine that cannot write
## files of more than a few kilobytes, as on a full disk. The last line has the outcomes.

const MotionRecorder := preload("res://demos/recording/motion_recorder.gd")
const PictureExport := preload("res://addons/ga_godot/playground/picture/picture_export.gd")
const Recording := preload("res://demos/recording/recording.gd")
const SafeFile := preload("res://addons/ga_godot/playground/document/safe_file.gd")
const Screenshot := preload("res://demos/multiplayer/view/screenshot.gd")

const FOLDER := "user://full_disk"
const MARK := "OUTCOMES "


func _init() -> void:
	print(MARK, JSON.stringify(_outcomes()))
	quit()


func _outcomes() -> Dictionary[String, Variant]:
	var scene := GAScene.new()
	scene.add_entry("a", "1")
	scene.set_entry_attribute("a", "note", "n".repeat(100000))
	var config := ConfigFile.new()
	config.set_value("session", "document", scene.document)
	# Less than what is buffered, so that only closing the file meets the full disk.
	var short := "s".repeat(3500).to_utf8_buffer()
	var noise := Crypto.new().generate_random_bytes(3 * 64 * 64)
	var picture := Image.create_from_data(64, 64, false, Image.FORMAT_RGB8, noise)
	var recorder := MotionRecorder.new()
	recorder.open(FOLDER.path_join("motion"), Recording.get_poses(0.0))
	for tick in 120:
		recorder.record(tick / 60.0, Recording.get_poses(tick / 60.0))
	return {
		"json": SafeFile.write(FOLDER.path_join("json"), scene.to_json().to_utf8_buffer()),
		"short": SafeFile.write(FOLDER.path_join("short"), short),
		"config": SafeFile.save_config(FOLDER.path_join("config"), config),
		"scene.tres": SafeFile.save_resource(FOLDER.path_join("scene.tres"), scene),
		"picture.png": PictureExport.save(picture, FOLDER.path_join("picture.png")),
		"screenshot.png": Screenshot.store(picture, FOLDER.path_join("screenshot.png")),
		"motion": [recorder.close(), recorder.error],
	}
