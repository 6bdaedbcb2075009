"""The engine's API description in terms of C++: classes, methods and types, from which generate.py writes the bindings."""

import re
import sys

BUILD_CONFIGURATION = "float_64"  # single precision, 64-bit pointers; others are not supported

# C++ types of the numeric types in the JSON; a "meta" overrides the type.
NUMBERS = {"bool": "bool", "int": "int64_t", "float": "double"}
INTEGERS = [f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)]
METAS = {**{name: name + "_t" for name in INTEGERS}, "float": "float", "double": "double"}
PLAIN = {*NUMBERS.values(), *METAS.values()}

# Built-in types written by hand, in include/godot_cpp/variant/.
HAND_WRITTEN = ("Vector2", "Vector3", "Quaternion", "AABB", "Basis", "Transform3D", "Color", "RID")


def snake_case(name):
    """File names as godot-cpp derives them: Node3D is node3d.hpp, PackedInt32Array is packed_int32_array.hpp."""
    name = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
    name = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name)
    return name.lower().replace("2_d", "2d").replace("3_d", "3d")


def packed(element):
    index = "gdextension_interface::{file}_operator_index"
    return "packed_array_base", f"PackedArrayBase<{{name}}, {element}, {{type}}, {index}, {index}_const>"


# Built-in types that are handles to engine memory: (header of the base class, base class). The class with the engine's
# methods is generated; its hand-written base class adds operators and conversions. Of the other built-in types only
# Variant is in the subset; methods that take or return one are not.
HANDLES = {
    "String": ("string_base", "StringBase"),
    "StringName": ("string_base", "StringNameBase"),
    "NodePath": ("opaque", "Opaque<{type}, 8>"),
    "Callable": ("opaque", "Opaque<{type}, 16>"),
    "Dictionary": ("array_base", "DictionaryBase"),
    "Array": ("array_base", "ArrayBase"),
    "PackedByteArray": packed("uint8_t"),
    "PackedInt32Array": packed("int32_t"),
    "PackedFloat32Array": packed("float"),
    "PackedFloat64Array": packed("double"),
    "PackedStringArray": packed("String"),
    "PackedVector3Array": packed("Vector3"),
}

# Operators of built-in types. The right operand has the same type, or the one in RIGHT_TYPES.
OPERATORS = {"==": "EQUAL", "!=": "NOT_EQUAL", "+": "ADD", "%": "MODULE"}
RIGHT_TYPES = {("String", "%"): "Array", ("StringName", "=="): None, ("StringName", "!="): None}  # None: written by hand

# The functions of the engine's C interface that are declared and loaded; add what the sources use. Those of packed arrays
# are in HANDLES.
INTERFACE_FUNCTIONS = """
    array_operator_index array_operator_index_const array_set_typed callable_custom_create2 classdb_construct_object2
    classdb_get_class_tag classdb_get_method_bind classdb_register_extension_class4 classdb_register_extension_class5
    classdb_register_extension_class_integer_constant classdb_register_extension_class_method
    classdb_register_extension_class_property classdb_register_extension_class_signal
    classdb_unregister_extension_class dictionary_operator_index dictionary_operator_index_const
    editor_help_load_xml_from_utf8_chars get_variant_from_type_constructor get_variant_to_type_constructor
    global_get_singleton mem_alloc mem_alloc2 mem_free mem_free2 object_cast_to object_destroy
    object_free_instance_binding object_get_instance_binding object_get_instance_from_id object_get_instance_id
    object_method_bind_call object_method_bind_ptrcall object_set_instance object_set_instance_binding
    print_error_with_message print_warning ref_get_object ref_set_object string_name_new_with_latin1_chars
    string_new_with_latin1_chars string_new_with_utf8_chars_and_len string_operator_plus_eq_string string_to_utf8_chars
    variant_can_convert_strict variant_destroy variant_get_object_instance_id variant_get_ptr_builtin_method
    variant_get_ptr_constructor variant_get_ptr_destructor variant_get_ptr_operator_evaluator variant_get_type
    variant_get_type_name variant_new_copy variant_new_nil worker_thread_pool_add_native_group_task
""".split() + [f"{snake_case(name)}_operator_index{const}" for name in HANDLES if name.startswith("Packed") for const in ("", "_const")]

# Engine methods that godot-cpp renames, and members that it adds to engine classes.
RENAMED_METHODS = {("Node", "get_node"): "get_node_internal"}
EXTRA_MEMBERS = {
    "WorkerThreadPool": """
	enum {
		INVALID_TASK_ID = -1
	};
	typedef int64_t GroupID;

	GroupID add_native_group_task(void (*p_func)(void *, uint32_t), void *p_userdata, int p_elements, int p_tasks = -1, bool p_high_priority = false, const String &p_description = String()) {
		return gdextension_interface::worker_thread_pool_add_native_group_task(_owner, p_func, p_userdata, p_elements, p_tasks, p_high_priority, p_description._native_ptr());
	}
""",
}


def variant_type(name):
    return "GDEXTENSION_VARIANT_TYPE_" + snake_case(name).upper()


class Api:
    """The part of the engine's API that the profile selects, and the C++ names of its types."""

    def __init__(self, description, profile):
        self.builtins = {entry["name"]: entry for entry in description["builtin_classes"]}
        self.global_enums = [entry for entry in description["global_enums"] if "." not in entry["name"]]
        self.variant_types, = [entry["values"] for entry in description["global_enums"] if entry["name"] == "Variant.Type"]
        self.singletons = {entry["type"]: entry["name"] for entry in description["singletons"]}
        sizes = {entry["build_configuration"]: entry["sizes"] for entry in description["builtin_class_sizes"]}
        self.sizes = {entry["name"]: entry["size"] for entry in sizes[BUILD_CONFIGURATION]}

        known = {entry["name"]: entry for entry in description["classes"]}
        wanted = {"Object", "RefCounted", *profile["enabled_classes"]}
        unknown = ", ".join(sorted(wanted - known.keys()))
        if unknown:
            sys.exit(f"generate.py: build_profile.json lists classes that this engine does not have: {unknown}; remove them")
        lines = {name: lineage(known, name) for name in known}
        wanted.update(*(lines[name] for name in list(wanted)))
        # Parents come before their children.
        self.classes = {name: known[name] for name in sorted(wanted, key=lambda name: (len(lines[name]), name))}

    def spell(self, json_type, meta=None):
        """The C++ type of a value; None if it is not in the subset."""
        if json_type in NUMBERS:
            return METAS.get(meta, NUMBERS[json_type])
        if json_type in (*HAND_WRITTEN, *HANDLES, "Variant"):
            return json_type
        if json_type in self.classes:
            return f"Ref<{json_type}>" if self.classes[json_type]["is_refcounted"] else f"{json_type} *"
        kind, _, name = json_type.partition("::")
        if kind in ("enum", "bitfield"):
            owner, _, enum = name.rpartition(".")
            spelled = f"{owner}::{enum}" if owner else enum
            known = not owner or owner in self.classes
            return (f"BitField<{spelled}>" if kind == "bitfield" else spelled) if known else None
        if kind == "typedarray":
            element = name if name in self.classes else self.spell(name)
            return element and f"TypedArray<{element}>"
        return None

    def default(self, json_type, text):
        """A default argument in C++, converted from its GDScript form."""
        spelled = self.spell(json_type)
        if json_type in NUMBERS or json_type in ("Vector2", "Vector3", "Transform3D", "Color"):
            return text
        if json_type.startswith(("enum::", "bitfield::")):
            return f"{spelled}({text})"
        if text == "null":
            return "nullptr" if spelled.endswith("*") else f"{spelled}()"
        if text in ("[]", "{}", '""', '&""', 'NodePath("")', f"{json_type}()"):
            return f"{spelled}()"
        if json_type in ("String", "StringName") and re.fullmatch(r'&?"[^"\\]*"', text):
            return text.lstrip("&")
        return sys.exit(f"generate.py: cannot convert the default value {text} of type {json_type} to C++; add it to Api.default")

    def methods(self, owner, entries):
        """The methods whose types are all in the subset."""
        found = []
        for entry in entries:
            # Classes describe a result in "return_value", built-in types in "return_type".
            value = entry.get("return_value") or ({"type": entry["return_type"]} if "return_type" in entry else None)
            result = self.spell(value["type"], value.get("meta")) if value else "void"
            arguments = entry.get("arguments", [])
            types = [self.spell(argument["type"], argument.get("meta")) for argument in arguments]
            if result and all(types):
                found.append(Method(self, owner, entry, result, list(zip(arguments, types))))
        return found

    def builtin_methods(self, name):
        return self.methods(name, [entry for entry in self.builtins[name]["methods"] if not entry["is_vararg"]])

    def class_methods(self, name, virtual):
        entries = self.classes[name].get("methods", [])
        return self.methods(name, [entry for entry in entries if entry["is_virtual"] == virtual])

    def constructors(self, name):
        """Constructors except the default and the copy constructor: (index, parameters, names of the arguments)."""
        for constructor in self.builtins[name]["constructors"][2:]:
            types = [self.spell(argument["type"]) for argument in constructor["arguments"]]
            names = ["p_" + argument["name"] for argument in constructor["arguments"]]
            if all(types):
                yield constructor["index"], ", ".join(map(parameter, types, names)), ", ".join(names)

    def operators(self, name):
        """Operators: (symbol, result, right type)."""
        for operator in self.builtins[name]["operators"]:
            symbol, right = operator["name"], operator.get("right_type")
            if symbol in OPERATORS and right == RIGHT_TYPES.get((name, symbol), name):
                yield symbol, self.spell(operator["return_type"]), right


def lineage(known, name):
    """A class and its ancestors."""
    parent = known[name].get("inherits")
    return [name] + (lineage(known, parent) if parent else [])


def parameter(spelled, name):
    """The declaration of a parameter."""
    if spelled in PLAIN:
        return f"{spelled} {name}"
    return f"{spelled}{name}" if spelled.endswith("*") else f"const {spelled} &{name}"


class Method:
    """A method of a built-in type or of an engine class, as C++ code."""

    def __init__(self, api, owner, entry, result, arguments):
        self.owner = owner
        self.engine_name = entry["name"]
        self.name = RENAMED_METHODS.get((owner, entry["name"]), entry["name"])
        self.hash = entry["hash"]
        self.is_vararg = entry["is_vararg"]
        self.static = "static " if entry["is_static"] else ""
        self.const = " const" if entry["is_const"] else ""
        self.result = result
        self.names = ["p_" + argument["name"] for argument, _ in arguments]
        self.types = [spelled for _, spelled in arguments]
        self.parameters, self.defaults = [], []
        for (argument, spelled), name in zip(arguments, self.names):
            is_enum = argument["type"].startswith("enum::")
            self.parameters.append(f"{spelled} {name}" if is_enum else parameter(spelled, name))
            # A built-in type's class is declared before Variant is complete, so it cannot have a Variant as default.
            has_default = "default_value" in argument and not (owner in HANDLES and spelled == "Variant")
            value = api.default(argument["type"], argument["default_value"]) if has_default else None
            self.defaults.append(f" = {value}" if value else "")

    @property
    def spaced_result(self):
        return self.result if self.result.endswith("*") else self.result + " "

    def declaration(self):
        parameters = ", ".join(map("".join, zip(self.parameters, self.defaults)))
        return f"{self.static}{self.spaced_result}{self.name}({parameters}){self.const};\n"

    def definition(self, body, parameters=None):
        parameters = ", ".join(self.parameters if parameters is None else parameters)
        return f"{self.spaced_result}{self.owner}::{self.name}({parameters}){self.const} {{\n{body}}}\n\n"

    def arguments(self, instance):
        return ", ".join(["method", "nullptr" if self.static else instance] + self.names)

    def lookup(self):
        """The statement that looks up a method of an engine class."""
        find = f'internal::find_method("{self.owner}", "{self.engine_name}", {self.hash})'
        return f"static const GDExtensionMethodBindPtr method = {find};"

    def text(self):
        """All types in the signature, to be searched for names."""
        return " ".join([self.result, *self.types])
