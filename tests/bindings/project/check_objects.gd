## Objects passed between scripts and C++: reference counts, null, freed objects, and wrappers.
extends Checks

var values: SampleValues = SampleValues.new()


func check_counts() -> void:
	var note: SampleNote = SampleNote.make("n", 1.0)
	same(note.get_reference_count(), 1)
	same(values.describe_note(note), "n 2")
	same(values.call("describe_note", note).begins_with("n "), true)
	same(note.get_reference_count(), 1)
	same(note.itself(), note)
	same(note.get_reference_count(), 1)
	var same_note: SampleNote = note.itself()
	same(note.get_reference_count(), 2)
	same_note = null
	same(note.get_reference_count(), 1)
	same(values.new_note("x").get_reference_count(), 1)
	same(values.call("new_note", "y").text, "y")
	same(note.copied().get_reference_count(), 1)
	same(note.copied().text, "n")
	var inside: SampleNote = values.note_as_variant()
	same(inside.text, "inside")
	same(inside.get_reference_count(), 1)


func check_destructors_run() -> void:
	var before: int = SampleValues.count_alive()
	var more: Array[SampleValues] = []
	for i: int in 10:
		more.append(SampleValues.new())
	same(SampleValues.count_alive(), before + 10)
	more.clear()
	same(SampleValues.count_alive(), before)
	SampleValues.make_and_drop(5)
	same(SampleValues.count_alive(), before)


func check_resources() -> void:
	var note: SampleNote = SampleNote.make("one")
	same(note.weight, 2.5)
	var changes: Array[int] = [0]
	note.changed.connect(func() -> void: changes[0] += 1)
	note.text = "two"
	note.values = PackedFloat64Array([1, 2])
	same(changes[0], 2)
	same(note.joined(SampleNote.make("three", 4.0)).text, "two+three")
	same(note.joined(note).weight, 5.0)
	expect_error("SampleNote.joined: the other note is null.")
	same(note.joined(null), null)
	expect_error("SampleNote: 5 values are more than 4.")
	note.values = PackedFloat64Array([1, 2, 3, 4, 5])
	same(note.values, PackedFloat64Array([1, 2]))
	same(str(note), "note:two")
	var copy: SampleNote = note.duplicate()
	same(copy.text, "two")
	same(copy.values, PackedFloat64Array([1, 2]))
	same(ResourceSaver.save(note, "user://note.tres"), OK)
	var loaded: SampleNote = ResourceLoader.load(
		"user://note.tres", "", ResourceLoader.CACHE_MODE_IGNORE
	)
	same(loaded.text, "two")
	same(loaded.values, PackedFloat64Array([1, 2]))


func check_null_and_classes() -> void:
	same(values.describe_object(null), "null")
	same(values.describe_note(null), "null")
	same(values.describe_node(null), "null")
	same(values.describe_object(values), "SampleValues")
	var body := RigidBody3D.new()
	body.name = "Body"
	# RigidBody3D is not in the build profile; its wrapper is that of Node3D.
	same(values.describe_node(body), "Body")
	same(values.describe_object(body), "RigidBody3D")
	body.free()


func check_freed_objects() -> void:
	var node := Node3D.new()
	var id: int = node.get_instance_id()
	values.keep(node)
	same(values.describe_kept(), "Node3D")
	same(values.is_alive(id), true)
	node.free()
	same(values.describe_kept(), "gone")
	same(values.is_alive(id), false)
	var freed: Array = [Node3D.new(), Node3D.new()]
	var typed: Array[Node3D] = [freed[0], freed[1]]
	typed[0].free()
	same(values.only_visible(typed).size(), 1)
	typed[1].visible = false
	same(values.only_visible(typed).size(), 0)
	typed[1].free()


func check_engine_resources() -> void:
	var multimesh := MultiMesh.new()
	var buffer := PackedFloat32Array()
	buffer.resize(36)
	for i: int in 3:
		for axis: int in 3:
			buffer[12 * i + 5 * axis] = 1.0
		buffer[12 * i + 3] = i
	values.fill_multimesh(multimesh, buffer)
	same(multimesh.instance_count, 3)
	same(multimesh.transform_format, MultiMesh.TRANSFORM_3D)
	same(multimesh.get_reference_count(), 1)
	expect_error("SampleValues.fill_multimesh: the multimesh is null.")
	values.fill_multimesh(null, buffer)


func check_threads() -> void:
	var threads: Array[Thread] = []
	for i: int in 4:
		threads.append(Thread.new())
		threads[i].start(chain_notes.bind(500))
	for thread: Thread in threads:
		same(thread.wait_to_finish(), 1250.0)


func chain_notes(count: int) -> float:
	var sum: float = 0.0
	for i: int in count:
		sum += values.new_note("x").joined(SampleNote.make("y", 1.5)).weight
	return sum


func check_singletons() -> void:
	same(SampleValues.is_editor(), Engine.is_editor_hint())
	same(SampleValues.is_editor(), false)


func check_scripts_on_extension_classes() -> void:
	var script := GDScript.new()
	script.source_code = "extends SampleNote\nfunc shout() -> String:\n\treturn text.to_upper()\n"
	same(script.reload(), OK)
	var note: SampleNote = script.new()
	note.text = "quiet"
	same(note.call("shout"), "QUIET")
	same(values.describe_note(note), "quiet 2")
