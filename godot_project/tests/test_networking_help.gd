extends "res://tests/framework/test_case.gd"
## The class reference of the replication classes documents every registered member.

const ClassReference := preload("res://tests/framework/class_reference.gd")

## The classes, with the number of examples in their reference.
const CLASSES: Dictionary[StringName, int] = {
	&"MotorSynchronizer": 2,
	&"MotorSender": 1,
	&"MotorReceiver": 1,
}


func test_the_reference_matches_what_is_registered() -> void:
	for type in CLASSES:
		var reference := ClassReference.new(type)
		expect_equal(reference.error, OK, "reading the class reference of %s" % type)
		var registered := reference.registered_methods()
		expect_true(registered.size() >= 6, "methods of %s" % type)
		for method_name in registered:
			expect_equal(
				reference.methods.get(method_name, ""),
				registered[method_name],
				"signature of %s" % method_name
			)
		expect_equal(reference.methods.size(), registered.size(), "number of methods of %s" % type)
		var members := reference.registered_members()
		for member_name in members:
			var documented: String = reference.members.get(member_name, "")
			expect_equal(
				documented.get_slice(" = ", 0),
				members[member_name].get_slice(" = ", 0),
				"type of %s" % member_name
			)
			if documented.get_slice(" = ", 0) in ["int", "float"]:
				expect_equal(
					documented.get_slice(" = ", 1).to_float(),
					members[member_name].get_slice(" = ", 1).to_float(),
					"default of %s" % member_name
				)
		var signals := reference.registered_signals()
		signals.sort()
		expect_equal(reference.signals, signals, "signals of %s" % type)
		for title: String in Array(registered.keys()) + Array(members.keys()):
			expect_true(reference.descriptions.has(title), "%s has a description" % title)
		expect_equal(reference.sample_count, CLASSES[type], "examples of %s" % type)
