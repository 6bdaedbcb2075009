"""Limits of size, and rules of spelling and layering that no other tool checks."""

import re

import sources

MAX_LINES = 400
MAX_PRIVATE_METHODS = 25
ENGINE_FREE = ("src/cga/", "src/net/", "src/playground/")
ENGINE_HEADER = re.compile(r'^\s*#\s*include\s*[<"](?:godot|godot_cpp)/')
# Integer types of <cstddef> and <cstdint>.
STD_INTEGER = re.compile(r"\bstd::(?:size_t|ptrdiff_t|u?int(?:_fast|_least)?(?:8|16|32|64)_t|u?intptr_t|u?intmax_t)\b")

# What may hold braces and parentheses that are no code.
NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
CLASS_HEAD = re.compile(r"\b(?P<kind>class|struct)\s+(?:\[\[\w+\]\]\s*)?(?P<name>[\w:]+)(?:<[^{};]*>)?\s*(?:final\s*)?(?::[^;{]*)?$", re.S)
ACCESS = re.compile(r"\b(public|protected|private)\s*$")
METHOD = re.compile(r"[\w~=+\-*/<>\]\)]\s*\(")


def long_files():
    """Files of ours with more than MAX_LINES lines."""
    found = []
    for path in sources.find("c++", "gdscript", "python", "shell"):
        lines = sources.read(path).count("\n")
        if lines > MAX_LINES:
            found.append(f"{path}: {lines} lines, at most {MAX_LINES} are allowed: split it by concept")
    return found


def crowded_classes():
    """Classes in headers with more than MAX_PRIVATE_METHODS private methods."""
    found = []
    for path in sources.find("c++"):
        if path.endswith(".hpp"):
            for name, count in private_methods(sources.read(path)).items():
                if count > MAX_PRIVATE_METHODS:
                    found.append(f"{path}: {name} has {count} private methods, at most {MAX_PRIVATE_METHODS} are allowed:"
                                 " move a responsibility to a class of its own")
    return found


def engine_includes():
    """Headers of the engine, or of src/godot, that engine-free code includes."""
    return [f"{place}: engine-free code includes {text.strip()}: move the code to src/godot"
            for place, text in _lines_matching(ENGINE_HEADER, ENGINE_FREE)]


def std_integers():
    """Integer types spelled with std::."""
    return [f"{place}: write {STD_INTEGER.search(text)[0][len('std::'):]} without std::"
            for place, text in _lines_matching(STD_INTEGER)]


def private_methods(text):
    """The number of private methods that each class in a header declares, by class name; nested classes count apart."""
    counts = {}
    scopes = []  # of each open brace: [class name or None, access]
    statement = ""
    for character in re.sub(r"^\s*#.*(?:\\\n.*)*", "", NO_CODE.sub('""', text), flags=re.M):
        access = ACCESS.search(statement) if character == ":" else None
        if character == "{":
            head = CLASS_HEAD.search(statement)
            _count(counts, scopes, statement)
            scopes.append([head["name"], "private" if head["kind"] == "class" else "public"] if head else [None, "public"])
            statement = ""
        elif character == "}":
            if scopes:
                scopes.pop()
            statement = ""
        elif character == ";":
            _count(counts, scopes, statement)
            statement = ""
        elif access and scopes:
            scopes[-1][1] = access[1]
            statement = ""
        else:
            statement += character
    return counts


def _count(counts, scopes, statement):
    """Counts the statement if it declares a private method of the innermost scope."""
    if not scopes or scopes[-1][0] is None:
        return
    name, access = scopes[-1]
    counts.setdefault(name, 0)
    declared = statement.split("=")[0] if "operator" not in statement else statement
    is_method = METHOD.search(declared) and not re.match(r"\s*(?:using|typedef|friend|static_assert)\b", declared)
    counts[name] += bool(access == "private" and is_method)


def _lines_matching(pattern, folders=("",)):
    """(PATH:LINE, text) of each line of C++ in these folders that the pattern matches."""
    for path in sources.find("c++"):
        if path.startswith(folders):
            for number, text in enumerate(sources.read(path).splitlines(), 1):
                if pattern.search(text):
                    yield f"{path}:{number}", text
