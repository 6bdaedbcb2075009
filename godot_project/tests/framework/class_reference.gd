extends RefCounted
## The class reference of one class: what its XML file documents and what the class registers.

const CodeSample := preload("res://tests/framework/code_sample.gd")

const FOLDER := "src/godot/doc_classes"
const CODE := "(?s)\\[codeblock\\](.*?)\\[/codeblock\\]"

## The text of each description by its subject: a name, or "signal NAME".
var descriptions: Dictionary[String, String] = {}
## Signatures by name, as "name(first: Type, second: Type = default) -> Type static".
var methods: Dictionary[String, String] = {}
## Type and default value by name.
var members: Dictionary[String, String] = {}
var signals := PackedStringArray()
## The number of code samples in the file.
var sample_count := 0
## The error of reading the file, or OK.
var error := OK

var _type: StringName


func _init(type: StringName) -> void:
	_type = type
	var path := folder().path_join("%s.xml" % type)
	sample_count = FileAccess.get_file_as_string(path).count("[codeblock]")
	var parser := XMLParser.new()
	error = parser.open(path)
	var title := ""
	var is_signal := false
	var qualifiers := ""
	var result := ""
	var parameters := PackedStringArray()
	while error == OK and parser.read() == OK:
		var element := (
			parser.get_node_name() if parser.get_node_type() != XMLParser.NODE_TEXT else ""
		)
		if parser.get_node_type() == XMLParser.NODE_ELEMENT:
			match element:
				"class":
					title = parser.get_named_attribute_value("name")
				"method", "signal":
					title = parser.get_named_attribute_value("name")
					is_signal = element == "signal"
					qualifiers = parser.get_named_attribute_value_safe("qualifiers")
					parameters.clear()
				"member":
					title = parser.get_named_attribute_value("name")
					members[title] = (
						"%s = %s"
						% [
							parser.get_named_attribute_value("type"),
							parser.get_named_attribute_value_safe("default")
						]
					)
				"return":
					result = parser.get_named_attribute_value("type")
				"param":
					var standard := parser.get_named_attribute_value_safe("default")
					parameters.append(
						(
							"%s: %s%s"
							% [
								parser.get_named_attribute_value("name"),
								parser.get_named_attribute_value("type"),
								"" if standard.is_empty() else " = %s" % standard
							]
						)
					)
				"brief_description":
					parser.skip_section()
		elif parser.get_node_type() == XMLParser.NODE_ELEMENT_END:
			if element == "method":
				methods[title] = (
					"%s(%s) -> %s %s" % [title, ", ".join(parameters), result, qualifiers]
				)
			elif element == "signal":
				signals.append("%s(%s)" % [title, ", ".join(parameters)])
		elif (
			parser.get_node_type() == XMLParser.NODE_TEXT
			and not parser.get_node_data().strip_edges().is_empty()
		):
			descriptions["signal %s" % title if is_signal else title] = parser.get_node_data()
			is_signal = false


static func folder() -> String:
	return CodeSample.repository().path_join(FOLDER)


## The code samples in a description, without their common indentation.
func samples_of(title: String) -> PackedStringArray:
	var samples := PackedStringArray()
	for found in RegEx.create_from_string(CODE).search_all(descriptions[title]):
		samples.append(found.get_string(1).dedent().strip_edges(true, true) + "\n")
	return samples


## Like [member methods], from ClassDB, without setters and getters.
func registered_methods() -> Dictionary[String, String]:
	var accessors := PackedStringArray()
	for property in ClassDB.class_get_property_list(_type, true):
		var property_name: String = property["name"]
		accessors.append(ClassDB.class_get_property_getter(_type, property_name))
		accessors.append(ClassDB.class_get_property_setter(_type, property_name))
	var result: Dictionary[String, String] = {}
	for method in ClassDB.class_get_method_list(_type, true):
		var method_name: String = method["name"]
		if method_name.begins_with("_") or method_name in accessors:
			continue
		var flags: int = method["flags"]
		var arguments: Array[Dictionary] = []
		arguments.assign(method["args"] as Array)
		var defaults: Array = method["default_args"]
		var parameters := PackedStringArray()
		for i in arguments.size():
			var standard := i - arguments.size() + defaults.size()
			parameters.append(
				(
					"%s: %s%s"
					% [
						arguments[i]["name"],
						_type_of(arguments[i]),
						"" if standard < 0 else " = %s" % var_to_str(defaults[standard])
					]
				)
			)
		var qualifiers := (
			"static" if flags & METHOD_FLAG_STATIC else "const" if flags & METHOD_FLAG_CONST else ""
		)
		result[method_name] = (
			"%s(%s) -> %s %s"
			% [
				method_name,
				", ".join(parameters),
				_type_of(method["return"] as Dictionary),
				qualifiers
			]
		)
	return result


## Like [member members], from ClassDB.
func registered_members() -> Dictionary[String, String]:
	var result: Dictionary[String, String] = {}
	for property in ClassDB.class_get_property_list(_type, true):
		var property_name: String = property["name"]
		var usage: int = property["usage"]
		if usage & (PROPERTY_USAGE_GROUP | PROPERTY_USAGE_CATEGORY) == 0:
			var type: int = property["type"]
			result[property_name] = (
				"%s = %s"
				% [
					type_string(type),
					var_to_str(ClassDB.class_get_property_default_value(_type, property_name))
				]
			)
	return result


## Like [member signals], from ClassDB.
func registered_signals() -> PackedStringArray:
	var result := PackedStringArray()
	for entry in ClassDB.class_get_signal_list(_type, true):
		var parameters := PackedStringArray()
		for argument: Dictionary in entry["args"]:
			parameters.append("%s: %s" % [argument["name"], _type_of(argument)])
		result.append("%s(%s)" % [entry["name"], ", ".join(parameters)])
	return result


func _type_of(info: Dictionary) -> String:
	var type: int = info["type"]
	var hint: int = info["hint"]
	if type == TYPE_ARRAY and hint == PROPERTY_HINT_ARRAY_TYPE:
		return "%s[]" % info["hint_string"]
	var usage: int = info["usage"]
	if type == TYPE_NIL:
		return "Variant" if usage & PROPERTY_USAGE_NIL_IS_VARIANT else "void"
	return info["class_name"] if type == TYPE_OBJECT else type_string(type)
