"""Finds what a script uses of the engine that an older version lacks.

Types are not inferred beyond declarations in the same file. A name is reported if it is in the API of a later version and
in no class of the old one, or if the declared or extended class has it only later.
"""

import re

STRING = re.compile(r'"""(?:.|\n)*?"""|&?\^?"(?:\\.|[^"\\\n])*"|&?\^?\'(?:\\.|[^\'\\\n])*\'')
COMMENT = re.compile(r"#[^\n]*")
DECLARED = re.compile(r"\b(?:var|const|func|signal|class|enum|class_name|for)\s+(\w+)|\b(\w+)\s*:(?==|\s*\w)|\{([\w\s,=]+)\}")
TYPED = re.compile(r"\b(\w+)\s*:\s*([A-Z]\w*)\b|\b(\w+)\s*:?=\s*([A-Z]\w*)\.new\(")
RECEIVED = re.compile(r"(?<![\w.)\]])(\w+)\.(\w+)")
BARE = re.compile(r"(?<![\w.@$%])([A-Za-z]\w*)")
EXTENDS = re.compile(r"^extends\s+(\w+)", re.M)
OVERRIDE = re.compile(r"^func (_\w+)", re.M)
CALL = re.compile(r"\.(\w+)\(")
# Calls and other uses by name. They need one of the guards in the same file.
BY_NAME = re.compile(r'\b(?:call|call_deferred|set|get|connect|instantiate|class_call_static)\(\s*&?"(\w+)"')
GUARD = re.compile(r"\b(?:class_exists|is_class|has_method|class_has_method)\(")
ANNOTATION = re.compile(r"^\s*(@\w+)", re.M)
LATER_ANNOTATIONS = {"@abstract", "@warning_ignore_start", "@warning_ignore_restore", "@export_file_path"}
REST_PARAMETER = re.compile(r"\bfunc\b[^\n]*\(.*\.\.\.")
SCENE_NODE = re.compile(r'^\[[^\]]*\btype="(\w+)"')
SCENE_PROPERTY = re.compile(r"^(\w+) = ")


class Checker:
    """Compares scripts with an old version and with the newest of several."""

    def __init__(self, old, newer, own):
        """`own` are the members that the project's scripts and extension classes declare."""
        self._old, self._newer, self._own = old, newer, own
        self._old_names = old.names()
        self._later = set().union(*(version.names() for version in newer)) - self._old_names
        self._old_counts = old.argument_counts()

    def check_script(self, text, base=None):
        """(line, what) of each use that the old version lacks. `base` is the engine class that the script extends, if it
        extends another script."""
        found = {(line_of(text, match), match[1]) for match in BY_NAME.finditer(text)
                 if match[1] in self._later and not GUARD.search(text)}
        code = without_comments(text)
        found |= {(line_of(code, match), match[1]) for match in ANNOTATION.finditer(code) if match[1] in LATER_ANNOTATIONS}
        found |= {(line_of(code, match), "...") for match in REST_PARAMETER.finditer(code)}
        groups = " ".join(text for match in DECLARED.finditer(code) for text in match.groups() if text)
        declared = set(groups.replace(",", " ").split())
        found |= self._new_names(code, declared)
        found |= self._new_members(code, declared, base or base_of(code))
        found |= self._new_ancestors(code)
        found |= self._more_arguments(code)
        return sorted(found)

    def _new_names(self, code, declared):
        known = declared | self._own
        return {(line_of(code, match), match[0]) for match in re.finditer(r"\b[A-Za-z_]\w*", code)
                if match[0] in self._later and match[0] not in known}

    def _new_members(self, code, declared, base):
        types = {}
        for match in TYPED.finditer(code):
            types.setdefault(match[1] or match[3], set()).add(match[2] or match[4])
        found = set()
        for match in RECEIVED.finditer(code):
            for owner in types.get(match[1], {match[1]}):
                if self._is_later(owner, match[2]):
                    found.add((line_of(code, match), f"{owner}.{match[2]}"))
        for match in BARE.finditer(code):
            if match[1] not in declared | self._own and self._is_later(base, match[1]):
                found.add((line_of(code, match), f"{base}.{match[1]}"))
        for match in OVERRIDE.finditer(code):
            if self._is_later(base, match[1]):
                found.add((line_of(code, match), f"{base}.{match[1]}"))
        return found

    def _new_ancestors(self, code):
        """Classes that a newer version derives from another class of the script, to which it may be assigned."""
        words = set(re.findall(r"\w+", code))
        found = set()
        for match in re.finditer(r"\b[A-Z]\w*", code):
            old = {entry["name"] for entry in self._old.lineage(match[0])}
            for version in self._newer if old else []:
                later = {entry["name"] for entry in version.lineage(match[0])} - old
                found |= {(line_of(code, match), f"{match[0]} as {name}") for name in later & words}
        return found

    def _is_later(self, owner, member):
        """Whether a class of the old version has the member only in a newer one."""
        if not self._old.lineage(owner) or member in self._old.members(owner):
            return False
        return any(member in version.members(owner) for version in self._newer if version.lineage(owner))

    def _more_arguments(self, code):
        found = set()
        for match in CALL.finditer(code):
            count = count_arguments(code, match.end())
            if match[1] not in self._own and count > self._old_counts.get(match[1], float("inf")):
                found.add((line_of(code, match), f"{match[1]} with {count} arguments"))
        return found

    def check_scene(self, text):
        """(line, what) of each class and property of a scene or resource that the old version lacks."""
        found, owner = [], None
        for number, line in enumerate(text.splitlines(), 1):
            if line.startswith("["):
                node = SCENE_NODE.match(line)
                owner = node[1] if node else None
                if owner in self._later:
                    found.append((number, owner))
            elif owner and SCENE_PROPERTY.match(line) and self._is_later(owner, SCENE_PROPERTY.match(line)[1]):
                found.append((number, f"{owner}.{SCENE_PROPERTY.match(line)[1]}"))
        return found


def base_of(text):
    """The engine class that a script names after `extends`; empty if it extends another script."""
    base = EXTENDS.search(text)
    return base[1] if base else ""


def declarations(text):
    """The members that a script declares."""
    return set(re.findall(r"^(?:static )?(?:var|const|func|signal|class|enum|class_name)\s+(\w+)", without_comments(text), re.M))


def without_comments(text):
    """The script without comments and without what is in strings; lines keep their numbers."""
    both = re.compile(f"{STRING.pattern}|{COMMENT.pattern}")
    return both.sub(lambda match: ("" if match[0].startswith("#") else '""') + "\n" * match[0].count("\n"), text)


def line_of(text, match):
    """The line of a match."""
    return text.count("\n", 0, match.start()) + 1


def count_arguments(code, start):
    """The number of arguments of a call whose parenthesis was opened before `start`."""
    depth, commas, is_empty = 0, 0, True
    last = ""
    for character in code[start:]:
        if character in ")]}" and depth == 0:
            break
        depth += (character in "([{") - (character in ")]}")
        commas += character == "," and depth == 0
        if not character.isspace():
            is_empty, last = False, character
    return 0 if is_empty else commas + (last != ",")
