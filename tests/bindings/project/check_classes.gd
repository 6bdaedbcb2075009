## The registration of the classes: properties, hints, base classes, types of arguments and results.
extends Checks


func check_hierarchy() -> void:
	same(ClassDB.get_parent_class("SampleNote"), &"Resource")
	same(ClassDB.get_parent_class("SampleChild"), &"SampleNode")
	same(ClassDB.is_parent_class("SampleChild", "Node"), true)
	same(ClassDB.can_instantiate("SampleMover"), true)
	same(ClassDB.instantiate("SampleNote").get_class(), "SampleNote")


func check_properties() -> void:
	var target: Dictionary = property_of("SampleNode", "target")
	same(target["type"], TYPE_NODE_PATH)
	same(target["hint"], PROPERTY_HINT_NODE_PATH_VALID_TYPES)
	same(target["hint_string"], "Node3D")
	var note: Dictionary = property_of("SampleNode", "note")
	same(note["type"], TYPE_OBJECT)
	same(note["class_name"], &"SampleNote")
	var node := SampleNode.new()
	same(node.note, null)
	node.note = SampleNote.make("kept")
	same(node.note.text, "kept")
	# The reference of the node, and that of this call.
	same(node.note.get_reference_count(), 2)
	node.free()


func check_types_of_methods() -> void:
	same(argument("move_all", 0)["hint"], PROPERTY_HINT_ARRAY_TYPE)
	same(argument("move_all", 0)["hint_string"], "Transform3D")
	same(argument("only_visible", 0)["hint_string"], "Node3D")
	same(argument("describe_note", 0)["class_name"], &"SampleNote")
	same(argument("describe_node", 0)["class_name"], &"Node3D")
	same(argument("halve", 0)["type"], TYPE_FLOAT)
	same(argument("add_up", 3)["name"], "d")
	same(
		argument("echo", 0)["usage"] & PROPERTY_USAGE_NIL_IS_VARIANT, PROPERTY_USAGE_NIL_IS_VARIANT
	)
	same(method_of("new_note")["return"]["class_name"], &"SampleNote")
	same(method_of("keep")["return"]["type"], TYPE_NIL)
	same(method_of("inspect")["return"]["type"], TYPE_ARRAY)


func property_of(type: StringName, property: String) -> Dictionary:
	for entry: Dictionary in ClassDB.class_get_property_list(type, true):
		if entry["name"] == property:
			return entry
	return {}


func argument(method: StringName, index: int) -> Dictionary:
	return method_of(method)["args"][index]
