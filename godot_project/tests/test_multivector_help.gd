extends "res://tests/framework/test_case.gd"
## The class reference of Multivector: it documents every member as registered, each with an example
## that runs and prints what it says.

const CodeSample := preload("res://tests/framework/code_sample.gd")

const REFERENCE := "src/godot/doc_classes/Multivector.xml"
const CODE := "(?s)\\[codeblock\\](.*?)\\[/codeblock\\]"


func test_every_method_is_documented_as_registered() -> void:
	var documented := _methods_in_reference()
	var registered := _registered_methods()
	for method_name in registered:
		expect_equal(documented.get(method_name, ""), registered[method_name], "signature of %s" % method_name)
	for method_name in documented:
		expect_true(registered.has(method_name), "registration of %s" % method_name)


func test_every_description_has_an_example_that_holds() -> void:
	var descriptions := _descriptions()
	expect_true(descriptions.size() > 60, "number of descriptions")
	for title in descriptions:
		var samples := RegEx.create_from_string(CODE).search_all(descriptions[title])
		expect_true(samples.size() > 0, "an example of %s" % title)
		for sample in samples:
			var code := sample.get_string(1).dedent().strip_edges(true, true) + "\n"
			expect_true(CodeSample.count_prints(code) > 0, "a checked print() in the example of %s" % title)
			expect_equal(CodeSample.find_faults(code), PackedStringArray(), "faults of the example of %s" % title)


## The text of each description, by what it describes.
func _descriptions() -> Dictionary[String, String]:
	var result: Dictionary[String, String] = {}
	var title := ""
	var parser := _open_reference()
	while parser.read() == OK:
		if parser.get_node_type() == XMLParser.NODE_ELEMENT:
			if parser.get_node_name() in ["class", "method", "member"]:
				title = parser.get_named_attribute_value("name")
			elif parser.get_node_name() == "brief_description":
				parser.skip_section()
		elif parser.get_node_type() == XMLParser.NODE_TEXT and not parser.get_node_data().strip_edges().is_empty():
			result[title] = parser.get_node_data()
	return result


## "static name(first: Type, second: Type = default) -> Type" by name.
func _methods_in_reference() -> Dictionary[String, String]:
	var result: Dictionary[String, String] = {}
	var method_name := ""
	var qualifiers := ""
	var type := ""
	var parameters := PackedStringArray()
	var parser := _open_reference()
	while parser.read() == OK:
		if parser.get_node_type() == XMLParser.NODE_ELEMENT:
			match parser.get_node_name():
				"method":
					method_name = parser.get_named_attribute_value("name")
					qualifiers = parser.get_named_attribute_value_safe("qualifiers")
					parameters.clear()
				"return":
					type = parser.get_named_attribute_value("type")
				"param":
					var standard := parser.get_named_attribute_value_safe("default")
					parameters.append("%s: %s%s" % [parser.get_named_attribute_value("name"),
							parser.get_named_attribute_value("type"), "" if standard.is_empty() else " = %s" % standard])
		elif parser.get_node_type() == XMLParser.NODE_ELEMENT_END and parser.get_node_name() == "method":
			result[method_name] = "%s(%s) -> %s %s" % [method_name, ", ".join(parameters), type, qualifiers]
	return result


func _registered_methods() -> Dictionary[String, String]:
	var result: Dictionary[String, String] = {}
	for method in ClassDB.class_get_method_list(&"Multivector", true):
		var method_name: String = method["name"]
		if method_name in ["get_coefficients", "set_coefficients"]:
			continue
		var flags: int = method["flags"]
		var arguments: Array[Dictionary] = []
		arguments.assign(method["args"] as Array)
		var defaults: Array = method["default_args"]
		var parameters := PackedStringArray()
		for i in arguments.size():
			var standard := i - arguments.size() + defaults.size()
			parameters.append("%s: %s%s" % [arguments[i]["name"], _type_of(arguments[i]),
					"" if standard < 0 else " = %s" % var_to_str(defaults[standard])])
		var qualifiers := "static" if flags & METHOD_FLAG_STATIC else "const" if flags & METHOD_FLAG_CONST else ""
		result[method_name] = "%s(%s) -> %s %s" % [method_name, ", ".join(parameters), _type_of(method["return"] as Dictionary), qualifiers]
	return result


func _type_of(info: Dictionary) -> String:
	var type: int = info["type"]
	return info["class_name"] if type == TYPE_OBJECT else type_string(type)


func _open_reference() -> XMLParser:
	var repository := ProjectSettings.globalize_path("res://").trim_suffix("/").get_base_dir()
	var parser := XMLParser.new()
	expect_equal(parser.open(repository.path_join(REFERENCE)), OK, "opening %s" % REFERENCE)
	return parser
