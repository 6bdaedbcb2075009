extends "res://tests/framework/test_case.gd"
## The class reference of GANode3D: every member is documented as registered.

const ClassReference := preload("res://tests/framework/class_reference.gd")

var _reference := ClassReference.new(&"GANode3D")


func test_every_member_is_documented_as_registered() -> void:
	expect_equal(_reference.error, OK, "reading the reference")
	var registered := _reference.registered_methods()
	for method_name in registered:
		expect_equal(
			_reference.methods.get(method_name, ""),
			registered[method_name],
			"signature of %s" % method_name
		)
	expect_equal(_reference.methods.size(), registered.size(), "number of methods")
	var members := _reference.registered_members()
	for member_name in members:
		var documented: String = _reference.members.get(member_name, "")
		var type := members[member_name].get_slice(" = ", 0)
		if type == "Object":
			expect_true(
				documented.get_slice(" = ", 0) in ["Multivector", "GAScene"],
				"the class of %s" % member_name
			)
		else:
			expect_equal(documented.get_slice(" = ", 0), type, "type of %s" % member_name)
	expect_equal(_reference.members.size(), members.size(), "number of members")
	for title: String in Array(registered.keys()) + Array(members.keys()):
		expect_true(_reference.descriptions.has(title), "a description of %s" % title)
	expect_equal(_reference.sample_count, 3, "examples")
