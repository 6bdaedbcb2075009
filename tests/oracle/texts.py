"""Text of multivectors and the expression language: JSON against Python's own module, expressions against `clifford`.

Texts are broken at random, and must be read or refused as Python reads or refuses them. Expressions are random trees,
written with as few brackets as the precedence of the language allows, or with some more, and computed by clifford.
"""

import json
import re
import string

import numpy as np
from clifford import g3c

LAYOUT = g3c.layout
BLADES = 32
ELEMENTS = 2000
BROKEN = 5000
EXPRESSIONS = 3000
NULL_NAMES = {"einf": g3c.einf, "eo": g3c.eo}


def check(library, report, seed):
    """Everything of this file."""
    random = np.random.default_rng([seed, 70])
    elements = random_elements(random)
    check_json(library, report, elements)
    check_broken_json(library, report, random, elements)
    check_text(library, report, elements)
    check_expressions(library, report, random)
    check_broken_expressions(library, report, random)


def random_elements(random):
    """Of all sizes that a double has, whole numbers, and with zeros of both signs."""
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


def check_broken_json(library, report, random, elements):
    answers = []
    for i in range(BROKEN):
        text = broken(random, library.to_json(elements[i % ELEMENTS]), '0123456789.,-+eE[]{}" :nulNaItrfy\\\n\t/*')
        wanted, (numbers, error) = read_by_python(text), library.from_json(text)
        if wanted is None:
            answers.append(numbers is None and bool(re.match(r"^(line \d+, )?column \d+: .+", error)))
        else:
            answers.append(numbers is not None and same_bits(numbers + 0.0, np.array(wanted) + 0.0))
    report.count("Python json", "broken texts read or refused alike, with the place", answers)


def broken(random, text, letters):
    """The text with one to three letters left out, put in, changed, or a part of it repeated."""
    for _ in range(random.integers(1, 4)):
        place, letter = int(random.integers(len(text) + 1)), letters[random.integers(len(letters))]
        kind = random.integers(5)
        if kind == 0:
            text = text[:place] + letter + text[place:]
        elif kind == 1:
            text = text[:place] + letter + text[place + 1 :]
        elif kind == 2:
            text = text[:place] + text[place + 1 :]
        elif kind == 3:
            text = text[:place] + text[max(0, place - int(random.integers(1, 6))) :]
        else:
            text = text[:place]
    return text


def read_by_python(text):
    """32 numbers, or None. What Python takes beyond JSON (NaN, Infinity, numbers too large) is refused here."""

    def refuse(_):
        raise ValueError

    try:
        numbers = json.loads(text, parse_constant=refuse)
    except (ValueError, RecursionError):
        return None
    good = isinstance(numbers, list) and len(numbers) == BLADES and all(type(x) in (int, float) for x in numbers)
    if not good or any(abs(x) > 1.7976931348623157e308 for x in numbers):
        return None
    return [float(x) for x in numbers]


def check_text(library, report, elements):
    """Read back by the language itself, and by a pattern of this file."""
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
    report.count("to_text", "read by a pattern", own)
    report.check("to_text", "in the null basis", null, 1e-15)


def sum_of(text):
    """The sum of products "2.5 e12^einf" with signs between them; None where it is something else."""
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


# Operators by how tight they bind, loosest first, and what they are.
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
    """(text, its level, value)"""
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
            # "1 / 2 e12" would be read in two ways, so the language asks for brackets.
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


def bracketed(random, text, level, wanted):
    """In brackets where the language needs them, and sometimes elsewhere."""
    return f"({text})" if level < wanted or random.uniform() < 0.1 else text


def check_expressions(library, report, random):
    errors = []
    for _ in range(EXPRESSIONS):
        text, _, value = expression(random, int(random.integers(1, 6)))
        ours, _ = library.evaluate(text)
        if ours is None:
            errors.append(np.inf)
        else:
            # Where all cancels, what is left is rounding of the parts.
            errors.append(np.abs(ours - value.value).max() / max(1.0, np.abs(value.value).max()))
    report.check("clifford", "evaluate of random expressions", errors, 1e-12)


def check_broken_expressions(library, report, random):
    """A finite value, or an error with its column."""
    answers = []
    for i in range(BROKEN):
        text = broken(random, expression(random, 3)[0], string.printable + "éλ∞")
        numbers, error = library.evaluate(text if i % 2 else text.encode()[: random.integers(1, 40)])
        answers.append(np.isfinite(numbers).all() if error is None else bool(re.match(r"^(line \d+, )?column \d+: .+", error)))
    report.count("evaluate", "broken expressions: a value or an error with its column", answers)
