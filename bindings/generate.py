#!/usr/bin/env python3
"""Writes the generated half of the bindings from what the engine dumps about itself.

See README.md for what is generated and what is written by hand. Needs the Python standard library only.
"""

import argparse
import json
import os
import re
import sys

BUILD_CONFIGURATION = "float_64"  # single precision, 64-bit pointers: the only one supported
NEWEST_INTERFACE = (4, 6)  # functions that only later engines have are left out, so that the library loads in 4.6

# C++ types of JSON types that are numbers, by their "meta" where they have one.
NUMBERS = {"bool": "bool", "int": "int64_t", "float": "double"}
INTEGERS = [f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)]
METAS = {**{name: name + "_t" for name in INTEGERS}, "float": "float", "double": "double"}
PLAIN = {*NUMBERS.values(), *METAS.values()}

# Built-in types written by hand, in include/godot_cpp/variant/.
HAND_WRITTEN = ("Vector2", "Vector3", "Quaternion", "AABB", "Basis", "Transform3D", "Color", "RID", "Variant")

# Built-in types that are handles to engine memory. The class with the methods is generated; what makes it pleasant to
# use from C++ is its hand-written base: (header of the base, base). Other built-in types are not in the subset, and
# neither is any method that takes or returns one.
INDEX = "gdextension_interface::{file}_operator_index"


def packed(element):
    return "packed_array_base", f"PackedArrayBase<{{name}}, {element}, {{type}}, {INDEX}, {INDEX}_const>"


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
    "PackedVector2Array": packed("Vector2"),
    "PackedVector3Array": packed("Vector3"),
    "PackedColorArray": packed("Color"),
}

# Operators of built-in types with an operand of the same type, or of the types given below it.
OPERATORS = {"==": "EQUAL", "!=": "NOT_EQUAL", "<": "LESS", "+": "ADD", "%": "MODULE"}
RIGHT_TYPES = {("String", "+"): ("String", "StringName"), ("String", "%"): ("Array",)}
RIGHT_TYPES.update({("StringName", "=="): (), ("StringName", "!="): ()})  # written by hand

UTILITY_FUNCTIONS = ("print", "push_error", "push_warning")

# Members that godot-cpp has beside the engine's own, and engine methods that it gives another name to make room.
RENAMED_METHODS = {("Node", "get_node"): "get_node_internal"}
EXTRA_MEMBERS = {
    "NodePath": """
	NodePath(const char *p_path) :
			NodePath(String(p_path)) {}
""",
    "Node": """
	template <typename T>
	T *get_node(const NodePath &p_path) const { return Object::cast_to<T>(get_node_internal(p_path)); }
""",
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


def snake_case(name):
    """File names as godot-cpp derives them: Node3D is node3d.hpp, PackedInt32Array is packed_int32_array.hpp."""
    name = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
    name = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name)
    return name.lower().replace("2_d", "2d").replace("3_d", "3d")


def variant_type(name):
    return "GDEXTENSION_VARIANT_TYPE_" + snake_case(name).upper()


def include(*paths):
    return "".join(f"#include <{path}.hpp>\n" for path in paths)


class Api:
    """The part of the engine's description that the profile asks for, and how its types are spelled in C++."""

    def __init__(self, description, profile):
        self.builtins = {entry["name"]: entry for entry in description["builtin_classes"]}
        self.global_enums = [entry for entry in description["global_enums"] if "." not in entry["name"]]
        self.utility_functions = {entry["name"]: entry for entry in description["utility_functions"]}
        self.singletons = {entry["type"]: entry["name"] for entry in description["singletons"]}
        sizes = {entry["build_configuration"]: entry["sizes"] for entry in description["builtin_class_sizes"]}
        self.sizes = {entry["name"]: entry["size"] for entry in sizes[BUILD_CONFIGURATION]}

        known = {entry["name"]: entry for entry in description["classes"]}
        wanted = {"Object", "RefCounted", *profile["enabled_classes"]}
        unknown = ", ".join(sorted(wanted - known.keys()))
        if unknown:
            sys.exit(f"generate.py: the build profile names classes that this engine does not have: {unknown}")
        lines = {name: lineage(known, name) for name in known}
        wanted.update(*(lines[name] for name in list(wanted)))
        # Parents come before their children.
        self.classes = {name: known[name] for name in sorted(wanted, key=lambda name: (len(lines[name]), name))}

    def spell(self, json_type, meta=None):
        """The C++ type of a value, or None where it is not in the subset."""
        if json_type in NUMBERS:
            return METAS.get(meta, NUMBERS[json_type])
        if json_type in HAND_WRITTEN or json_type in HANDLES:
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
        """A default argument in C++, from the way the engine writes it in its own script language."""
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
        return sys.exit(f"generate.py: no C++ form is known for the default value {text} of type {json_type}")

    def methods(self, owner, entries):
        """Those methods that need no type outside the subset."""
        found = []
        for entry in entries:
            # Built-in types and classes differ in how they tell a result.
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
        """Constructors beyond the default and the copying one: (index, parameters, names of the arguments)."""
        for constructor in self.builtins[name]["constructors"][2:]:
            types = [self.spell(argument["type"]) for argument in constructor["arguments"]]
            names = ["p_" + argument["name"] for argument in constructor["arguments"]]
            if all(types):
                yield constructor["index"], ", ".join(map(parameter, types, names)), ", ".join(names)

    def operators(self, name):
        """Operators: (symbol, result, right type)."""
        for operator in self.builtins[name]["operators"]:
            symbol, right = operator["name"], operator.get("right_type")
            if symbol in OPERATORS and right in RIGHT_TYPES.get((name, symbol), (name,)):
                yield symbol, self.spell(operator["return_type"]), right


def lineage(known, name):
    """A class and its ancestors."""
    parent = known[name].get("inherits")
    return [name] + (lineage(known, parent) if parent else [])


def parameter(spelled, name):
    """How a function declares an argument."""
    if spelled in PLAIN:
        return f"{spelled} {name}"
    return f"{spelled}{name}" if spelled.endswith("*") else f"const {spelled} &{name}"


class Method:
    """A method of a built-in type or of an engine class, in the words of C++."""

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
        """How an engine class's method finds itself in the engine."""
        find = f'internal::find_method("{self.owner}", "{self.engine_name}", {self.hash})'
        return f"static const GDExtensionMethodBindPtr method = {find};"

    def text(self):
        """What to search for the types that it names."""
        return " ".join([self.result, *self.types])


class Output:
    """Writes files into one folder and leaves those alone that would not change, so that nothing is built twice."""

    def __init__(self, folder):
        self.folder = folder

    def write(self, path, text):
        path = os.path.join(self.folder, path)
        try:
            with open(path, encoding="utf-8") as file:
                if file.read() == text:
                    return
        except FileNotFoundError:
            os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def header(self, path, includes, body, after="", namespace="godot"):
        """A header of godot_cpp; after is what follows the namespace."""
        text = f"#pragma once\n\n{includes}\nnamespace {namespace} {{\n\n{body}\n}} // namespace {namespace}\n{after}"
        self.write(f"include/godot_cpp/{path}.hpp", NOTICE + text)

    def source(self, path, includes, body, namespace="godot"):
        text = f"{includes}\nnamespace {namespace} {{\n\n{body}}} // namespace {namespace}\n"
        self.write(f"src/{path}.cpp", NOTICE + text)


NOTICE = "// Generated by bindings/generate.py from the engine's own description. Edits will be lost.\n\n"


def enum_text(enum, indent=""):
    underlying = " : uint64_t" if enum["is_bitfield"] else ""
    values = "".join(f"{indent}\t{value['name']} = {value['value']},\n" for value in enum["values"])
    return f"{indent}enum {enum['name']}{underlying} {{\n{values}{indent}}};\n\n"


def enum_casts(enums, prefix=""):
    return "".join(f"VARIANT_ENUM_CAST({prefix}{enum['name']});\n" for enum in enums if not enum["is_bitfield"])


def write_interface(output, header):
    """The engine's C interface, one pointer a function, and the loader that fills them."""
    functions = []
    for comment, definition in re.findall(r"/\*\*(.*?)\*/\s*typedef ([^;]+);", header, re.S):
        name = re.search(r"@name (\w+)", comment)
        since = re.search(r"@since (\d+)\.(\d+)", comment)
        pointer = re.search(r"\(\*(\w+)\)", definition)
        if name and since and pointer and tuple(map(int, since.groups())) <= NEWEST_INTERFACE:
            functions.append((name[1], pointer[1]))
    if not functions:
        sys.exit("generate.py: the interface header names no functions")

    load = "const char *load(GDExtensionInterfaceGetProcAddress p_get_proc_address)"
    declarations = "".join(f"extern {pointer} {name};\n" for name, pointer in functions)
    definitions = "".join(f"{pointer} {name} = nullptr;\n" for name, pointer in functions)
    loads = "".join(
        f'\tif (({name} = reinterpret_cast<{pointer}>(p_get_proc_address("{name}"))) == nullptr) {{\n'
        f'\t\treturn "{name}";\n\t}}\n' for name, pointer in functions)
    contract = "// Fills every pointer above. Returns the name of a function that this engine lacks, or null.\n"
    namespace = "godot::gdextension_interface"
    path = "core/gdextension_interface_loader"
    output.write("include/gdextension_interface.h", header)
    output.header(path, "#include <gdextension_interface.h>\n", f"{declarations}\n{contract}{load};\n", "", namespace)
    body = f"{definitions}\n{load} {{\n{loads}\treturn nullptr;\n}}\n\n"
    output.source("interface", include("godot_cpp/" + path), body, namespace)


def write_builtin_header(output, api, name):
    header, base = HANDLES[name]
    base = base.format(name=name, type=variant_type(name), file=snake_case(name))
    needed = ["string", "string_name"][:list(HANDLES).index(name)]  # for default arguments
    includes = include(*(f"godot_cpp/variant/{path}" for path in [header] + needed))
    structs = set(HAND_WRITTEN) - {"Variant"}
    forward = "".join(f"{'struct' if other in structs else 'class'} {other};\n"
                      for other in sorted({*HANDLES, *HAND_WRITTEN, "Object"} - {name}))
    base_name = base.split("<")[0]
    members = f"\tusing {base_name}::{base_name};\n\n"
    members += "".join(f"\t{name}({parameters});\n" for _, parameters, _ in api.constructors(name))
    members += EXTRA_MEMBERS.get(name, "").lstrip("\n")
    members += "".join("\t" + method.declaration() for method in api.builtin_methods(name))
    members += "".join(f"\t{result} operator{symbol}(const {right} &p_other) const;\n"
                       for symbol, result, right in api.operators(name))
    body = f"{forward}\nclass {name} : public internal::{base} {{\npublic:\n{members}}};\n"
    output.header(f"variant/{snake_case(name)}", includes, body)


def write_builtin_source(output, api):
    interface = "gdextension_interface::variant_get_ptr"
    body = "".join(f"static_assert(sizeof({name}) == {api.sizes[name]});\n" for name in [*HAND_WRITTEN, *HANDLES])
    for name in HANDLES:
        variant = variant_type(name)
        for index, parameters, names in api.constructors(name):
            body += f"""
{name}::{name}({parameters}) :
		{name}(internal::Uninitialized()) {{
	static const GDExtensionPtrConstructor constructor = {interface}_constructor({variant}, {index});
	internal::call_constructor(constructor, _native_ptr(), {names});
}}
"""
        body += "\n"
        for method in api.builtin_methods(name):
            key = f'{variant}, "{method.engine_name}", {method.hash}'
            body += method.definition(
                f"\tstatic const GDExtensionPtrBuiltInMethod method = internal::find_builtin_method({key});\n"
                f"\treturn internal::call_builtin_method<{method.result}>({method.arguments('_native_ptr()')});\n")
        for symbol, result, right in api.operators(name):
            key = f"GDEXTENSION_VARIANT_OP_{OPERATORS[symbol]}, {variant}, {variant_type(right)}"
            body += f"""{result} {name}::operator{symbol}(const {right} &p_other) const {{
	static const GDExtensionPtrOperatorEvaluator evaluator = {interface}_operator_evaluator({key});
	return internal::call_operator<{result}>(evaluator, _native_ptr(), p_other._native_ptr());
}}

"""
    output.source("builtin_types", include("godot_cpp/core/call", "godot_cpp/core/object"), body)


def write_global_constants(output, api):
    constants = "".join(map(enum_text, api.global_enums))
    output.header("classes/global_constants", "#include <cstdint>\n", constants)
    includes = include("godot_cpp/classes/global_constants", "godot_cpp/core/binder_common")
    casts = enum_casts(api.global_enums)
    output.write("include/godot_cpp/classes/global_constants_binds.hpp", f"{NOTICE}#pragma once\n\n{includes}\n{casts}")


def write_utility_functions(output, api):
    members = ""
    for name in UTILITY_FUNCTIONS:
        key = f'"{name}", {api.utility_functions[name]["hash"]}'
        members += f"""	template <typename... Args>
	static void {name}(const Variant &p_arg1, const Args &...p_args) {{
		internal::call_utility_function({key}, p_arg1, p_args...);
	}}
"""
    body = f"class UtilityFunctions {{\npublic:\n{members}}};\n"
    output.header("variant/utility_functions", include("godot_cpp/core/call"), body)


def vararg_text(method):
    """Engine methods with any number of arguments are templates in C++ that pass an array of Variants."""
    parameters = ", ".join([*method.parameters, "const Args &...p_args"])
    call = f"internal::call_vararg_method({', '.join(['method', '_owner', *method.names, 'p_args...'])})"
    body = call if method.result == "void" else f"return internal::from_variant<{method.result}>({call})"
    return f"""	template <typename... Args>
	{method.spaced_result}{method.name}({parameters}){method.const} {{
		{method.lookup()}
		{body};
	}}
"""


def write_class_header(output, api, name):
    entry = api.classes[name]
    parent = entry.get("inherits", "Wrapped")
    methods, virtuals = api.class_methods(name, False), api.class_methods(name, True)
    named = " ".join(method.text() for method in methods + virtuals)
    used = {other for other in api.classes if other != name and re.search(rf"\b{other}\b", named)}
    by_enum = {other for other in used if other + "::" in named and other != parent}  # must be complete

    includes = include(*(f"godot_cpp/classes/{snake_case(other)}" for other in [parent, *sorted(by_enum)]))
    includes += include("godot_cpp/classes/ref") if "Ref<" in named else ""
    includes += include("godot_cpp/core/call" if name == "Object" else "godot_cpp/core/class_db")
    forward = "".join(f"class {other};\n" for other in sorted(used - by_enum))

    public = "".join(enum_text(enum, "\t") for enum in entry.get("enums", []))
    public += "".join(f"\tstatic constexpr auto {constant['name']} = {constant['value']};\n"
                      for constant in entry.get("constants", []))
    if name in api.singletons:
        public += f"\tstatic {name} *get_singleton();\n"
    for method in methods:
        public += vararg_text(method) if method.is_vararg else "\t" + method.declaration()
    public += EXTRA_MEMBERS.get(name, "").lstrip("\n") + "\n"
    public += "".join("\tvirtual " + method.declaration() for method in virtuals)

    overrides = f"\t\t{parent}::register_virtuals<T>(p_class);\n" if parent != "Wrapped" else ""
    for method in virtuals:
        pointers = f"T, &{name}::{method.name}, &T::{method.name}"
        overrides += f'\t\tinternal::bind_override<{pointers}>(p_class, "{method.engine_name}", {method.hash}u);\n'
    body = f"""{forward}
class {name} : public {parent} {{
	GDEXTENSION_CLASS({name}, {parent})

public:
{public}
protected:
	template <typename T>
	static void register_virtuals([[maybe_unused]] internal::ClassInfo &p_class) {{
{overrides}	}}
}};
"""
    casts = enum_casts(entry.get("enums", []), f"{name}::")
    output.header(f"classes/{snake_case(name)}", includes, body, "\n" + casts if casts else "")


def write_class_source(output, api):
    includes = include(*(f"godot_cpp/classes/{snake_case(name)}" for name in api.classes))
    includes += include("godot_cpp/classes/ref")
    body = ""
    for name in api.classes:
        if name in api.singletons:
            body += f"""{name} *{name}::get_singleton() {{
	static internal::Singleton singleton;
	return static_cast<{name} *>(singleton.get("{api.singletons[name]}"));
}}

"""
        for method in api.class_methods(name, False):
            if not method.is_vararg:
                call = f"internal::call_method<{method.result}>({method.arguments('_owner')})"
                body += method.definition(f"\t{method.lookup()}\n\treturn {call};\n")
        for method in api.class_methods(name, True):
            unnamed = [re.sub(r" ?p_\w+$", "", text) for text in method.parameters]
            body += method.definition("" if method.result == "void" else "\treturn {};\n", unnamed)
    table = "".join(f'\t{{ "{name}", &WrapperFactory::create<{name}>, nullptr }},\n' for name in api.classes)
    body += f"""namespace internal {{

// Parents come before their children.
EngineClass engine_classes[] = {{
{table}}};
const int engine_class_count = {len(api.classes)};

}} // namespace internal

"""
    output.source("engine_classes", includes, body)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__.splitlines()[0], formatter_class=argparse.RawDescriptionHelpFormatter, epilog="""
It writes DIR/include (gdextension_interface.h, godot_cpp/core/gdextension_interface_loader.hpp,
godot_cpp/classes/*.hpp, godot_cpp/variant/*.hpp) and DIR/src (interface.cpp, builtin_types.cpp, engine_classes.cpp).
Files whose content would stay the same are not touched. Compile DIR/src/*.cpp and bindings/src/*.cpp with
bindings/include and DIR/include as include paths. Only single precision on 64 bits (float_64) is supported.""")
    parser.add_argument("--api", required=True, metavar="JSON", help="extension_api.json (--dump-extension-api)")
    parser.add_argument("--interface", required=True, metavar="HEADER", help="gdextension_interface.h of that engine")
    parser.add_argument("--profile", required=True, metavar="JSON", help="build profile: the engine classes to offer")
    parser.add_argument("--output", required=True, metavar="DIR", help="where to write")
    options = parser.parse_args()

    with open(options.api, encoding="utf-8") as file:
        description = json.load(file)
    if description["header"].get("precision", "single") != "single":
        sys.exit("generate.py: this engine was built with double precision, which the bindings do not support")
    with open(options.profile, encoding="utf-8") as file:
        api = Api(description, json.load(file))
    output = Output(options.output)
    with open(options.interface, encoding="utf-8") as file:
        write_interface(output, file.read())
    write_global_constants(output, api)
    write_utility_functions(output, api)
    for name in HANDLES:
        write_builtin_header(output, api, name)
    write_builtin_source(output, api)
    for name in api.classes:
        write_class_header(output, api, name)
    write_class_source(output, api)


if __name__ == "__main__":
    main()
