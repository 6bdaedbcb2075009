"""Text of multivectors and the expression language: JSON compared with Python's module, expressions with `clifford`.

Randomly corrupted JSON must be accepted or rejected as by Python. Expressions are random trees, written with the brackets
that the precedence of the language requires and some more, and evaluated by clifford.
"""

import json
import re
import string

import numpy as np
from clifford import g3c

LAYOUT = g3c.layout
BLADES = 32
ELEMENTS = 2000
CORRUPTED = 5000
EXPRESSIONS = 3000
NULL_NAMES = {"einf": g3c.einf, "eo": g3c.eo}


def check(library, report, seed):
    """Runs the checks of this file."""
    random = np.random.default_rng([seed, 70])
    elements = random_elements(random)
    check_json(library, report, elements)
    check_corrupted_json(library, report, random, elements)
    check_text(library, report, elements)
    check_expressions(library, report, random)
    check_corrupted_expressions(library, report, random)


def random_elements(random):
    """Elements of all magnitudes of doubles, of integers, and with zeros of both signs."""
    elements = random.standard_normal((ELEMENTS, BLADES)) * 10.0 ** random.uniform(-320, 300, (ELEMENTS, BLADES))
    elements[::2] = random.standard_normal((ELEMENTS // 2, BLADES)) * 10.0 ** random.integers(-3, 4, (ELEMENTS // 2, 1))
    elements[::5] = random.integers(-9, 10, (len(elements[::5]), BLADES))
    elements[random.uniform(size=elements.shape) < 0.5] = 0.0
    elements[1], elements[3], elements[5] = 5e-324, -1.7976931348623157e308, -0.0
    return elements


def check_json(library, report, elements):
    texts = [library.to_json(element) for element in elements]
    same = [same_bits(json.loads(text, parse_int=float), element) for text, element in zip(texts, elements)]
    report.count("Python json", "reads what to_json writes, bit for bit", same)
    back = [same_bits(library.from_json(text)[0], element) for text, element in zip(texts, elements)]
    report.count("Python json", "from_json(to_json(x)) == x, bit for bit", back)
    written = [library.from_json(json.dumps(list(element), indent=int(i % 3))) for i, element in enumerate(elements)]
    report.count("Python json", "from_json reads what Python writes", [same_bits(*pair) for pair in zip([w[0] for w in written], elements)])


def same_bits(numbers, element):
    return numbers is not None and np.array(numbers, float).tobytes() == np.ascontiguousarray(element).tobytes()


def check_corrupted_json(library, report, random, elements):
    successes = []
    for i in range(CORRUPTED):
        text = corrupted(random, library.to_json(elements[i % ELEMENTS]), '0123456789.,-+eE[]{}" :nulNaItrfy\\\n\t/*')
        expected, (numbers, error) = read_by_python(text), library.from_json(text)
        if expected is None:
            successes.append(numbers is None and bool(re.match(r"^(line \d+, )?column \d+: .+", error)))
        else:
            successes.append(numbers is not None and same_bits(numbers + 0.0, np.array(expected) + 0.0))
    report.count("Python json", "corrupted texts accepted or rejected alike, with the position of the error", successes)


def corrupted(random, text, letters):
    """The text after one to three random edits: insertion, replacement, removal, repetition, truncation."""
    for _ in range(random.integers(1, 4)):
        position, letter = int(random.integers(len(text) + 1)), letters[random.integers(len(letters))]
        kind = random.integers(5)
        if kind == 0:
            text = text[:position] + letter + text[position:]
        elif kind == 1:
            text = text[:position] + letter + text[position + 1 :]
        elif kind == 2:
            text = text[:position] + text[position + 1 :]
        elif kind == 3:
            text = text[:position] + text[max(0, position - int(random.integers(1, 6))) :]
        else:
            text = text[:position]
    return text


def read_by_python(text):
    """32 numbers, or None. Rejects what Python accepts beyond JSON: NaN, Infinity, numbers that are too large."""

    def reject(_):
        raise ValueError

    try:
        numbers = json.loads(text, parse_constant=reject)
    except (ValueError, RecursionError):
        return None
    is_valid = isinstance(numbers, list) and len(numbers) == BLADES and all(type(x) in (int, float) for x in numbers)
    if not is_valid or any(abs(x) > 1.7976931348623157e308 for x in numbers):
        return None
    return [float(x) for x in numbers]


def check_text(library, report, elements):
    """Text parsed by the expression language and by a regular expression."""
    back, own, null = [], [], []
    for element in elements:
        text = library.to_text(element, False)
        numbers, _ = library.evaluate(text)
        back.append(numbers is not None and same_bits(numbers + 0.0, element + 0.0))
        own.append(np.array_equal(sum_of(text), element))
        text = library.to_text(element, True)
        numbers, _ = library.evaluate(text)
        size = np.abs(element).max()
        for value in (numbers, sum_of(text)) if 1e-290 < size < 1e300 else ():
            null.append(np.abs(value / size - element / size).max() if value is not None else np.inf)
    report.count("to_text", "evaluate(to_text(x)) == x, bit for bit", back)
    report.count("to_text", "parsed by a regular expression", own)
    report.check("to_text", "in the null basis", null, 1e-15)


def sum_of(text):
    """Evaluates a sum of terms like "2.5 e12^einf"; None if the text is something else."""
    total = np.zeros(BLADES)
    terms = re.split(r" (?=[+-] )", text) if text != "0" else []
    for term in terms:
        match = re.fullmatch(r"([+-])? ?([0-9.]+(?:e[+-]?[0-9]+)?)?(?: ?(e[0-9a-z^]+))?", term)
        if not match or not (match[2] or match[3]):
            return None
        blade = LAYOUT.scalar
        for factor in match[3].split("^") if match[3] else ():
            blade = blade ^ (NULL_NAMES[factor] if factor in NULL_NAMES else LAYOUT.blades[factor])
        total = total + float(match[2] or 1) * (-1.0 if match[1] == "-" else 1.0) * blade.value
    return total


# Operators by precedence, lowest first.
LEVELS = (("+", "-"), ("*", "/"), ("|", "<<", ">>", "&"), ("^",))
PREFIX = len(LEVELS)
ATOM = PREFIX + 1
DUAL = LAYOUT.pseudoScalar.inv()


def fat_dot(a, b):
    x, y = a.value[0], b.value[0]
    return ((a - x) | (b - y)) + x * b + y * a - x * y


BINARY = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "|": fat_dot,
    "<<": lambda a, b: a.lc(b),
    ">>": lambda a, b: ~((~b).lc(~a)),
    "&": lambda a, b: ((a * DUAL) ^ (b * DUAL)) * LAYOUT.pseudoScalar,
    "^": lambda a, b: a ^ b,
}
UNARY = {"-": lambda a: -a, "~": lambda a: ~a, "!": lambda a: a * DUAL, "+": lambda a: a}


def expression(random, depth):
    """(text, precedence, value)"""
    kind = random.uniform()
    if depth == 0 or kind < 0.1:
        return leaf(random)
    if kind < 0.25:
        sign = str(random.choice(list(UNARY)))
        text, level, value = expression(random, depth - 1)
        return sign + bracketed(random, text, level, PREFIX), PREFIX, UNARY[sign](value)
    rank = int(random.integers(len(LEVELS)))
    sign = str(random.choice(LEVELS[rank]))
    left, left_level, a = expression(random, depth - 1)
    if sign == "/":
        right, right_level, b = leaf(random)
        while abs((b * ~b).value[0]) < 1e-3:
            right, right_level, b = leaf(random)
        value = a * b.hitzer_inverse()
        if " " in right:
            # "1 / 2 e12" is ambiguous: the language requires brackets.
            right = f"({right})"
    else:
        right, right_level, b = expression(random, depth - 1)
        value = BINARY[sign](a, b)
    gap = " " * int(random.integers(0, 2))
    text = bracketed(random, left, left_level, rank) + gap + sign + gap + bracketed(random, right, right_level, rank + 1)
    return text, rank, value


def leaf(random):
    kind = random.uniform()
    if kind < 0.3:
        number = str(round(random.uniform(0.0, 5.0), int(random.integers(0, 4))))
        return number, ATOM, LAYOUT.scalar * float(number)
    if kind < 0.45:
        name = str(random.choice(["einf", "eo", "ei", "E", "I", "pi", "tau"]))
        plane = g3c.einf ^ g3c.eo
        value = {"einf": g3c.einf, "ei": g3c.einf, "eo": g3c.eo, "E": plane, "I": LAYOUT.pseudoScalar,
                 "pi": LAYOUT.scalar * np.pi, "tau": LAYOUT.scalar * 2 * np.pi}[name]
        return name, ATOM, value
    digits = random.permutation([1, 2, 3, 4, 5])[: random.integers(1, 6)]
    value = LAYOUT.scalar
    for digit in digits:
        value = value * LAYOUT.blades[f"e{digit}"]
    name = "e" + "".join(map(str, digits))
    if kind < 0.7:
        number = str(round(random.uniform(0.1, 5.0), 2))
        return f"{number} {name}", ATOM, value * float(number)
    return name, ATOM, value


def bracketed(random, text, level, min_level):
    """The text in brackets where the precedence requires them, and sometimes elsewhere."""
    return f"({text})" if level < min_level or random.uniform() < 0.1 else text


def check_expressions(library, report, random):
    errors = []
    for _ in range(EXPRESSIONS):
        text, _, value = expression(random, int(random.integers(1, 6)))
        ours, _ = library.evaluate(text)
        if ours is None:
            errors.append(np.inf)
        else:
            # If all terms cancel, the rounding of the terms remains.
            errors.append(np.abs(ours - value.value).max() / max(1.0, np.abs(value.value).max()))
    report.check("clifford", "evaluate of random expressions", errors, 1e-12)


def check_corrupted_expressions(library, report, random):
    """A finite value, or an error with its column."""
    successes = []
    for i in range(CORRUPTED):
        text = corrupted(random, expression(random, 3)[0], string.printable + "éλ∞")
        numbers, error = library.evaluate(text if i % 2 else text.encode()[: random.integers(1, 40)])
        successes.append(np.isfinite(numbers).all() if error is None else bool(re.match(r"^(line \d+, )?column \d+: .+", error)))
    report.count("evaluate", "corrupted expressions: a value or an error with its column", successes)
