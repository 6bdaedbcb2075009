"""The C interface of the C++ algebra (*_oracle.cpp) for NumPy arrays."""

import ctypes

import numpy as np

BLADES = 32
MODES = ["LINEAR", "SCREW", "SEPARATE"]

POSE_NUMBERS = 8  # t1 t2 t3 qw qx qy qz s
LOG_NUMBERS = 7  # w1 w2 w3 v1 v2 v3 sigma
ROW_NUMBERS = 12  # a 3 x 4 matrix, row by row
TEXT_SIZE = 8192
CLASS_NUMBERS = 21  # as objects_oracle.cpp stores them
CLASS_PARTS = {"residual": slice(3, 4), "radius": slice(4, 5), "distance": slice(5, 6), "center": slice(6, 9),
               "normal": slice(9, 12), "direction": slice(12, 15)}
KINDS = ["scalar", "point", "point_pair", "circle", "sphere", "flat_point", "line", "plane", "direction", "tangent",
         "rotor", "translator", "dilator", "motor", "none"]


class Library:
    """Functions take and return arrays with one element per row; NaN where there is no result."""

    def __init__(self, path):
        self._library = ctypes.CDLL(path)

    def unary(self, name, operands):
        """A function of UNARY in elements_oracle.cpp, of one multivector."""
        return self.unary_with_reasons(name, operands)[0]

    def unary_with_reasons(self, name, operands):
        """The results, and for each None or the reason why there is none."""
        return self._elements("oracle_unary", name, operands)

    def binary(self, name, left, right):
        """A function of BINARY in elements_oracle.cpp, of two multivectors."""
        return self.binary_with_reasons(name, left, right)[0]

    def binary_with_reasons(self, name, left, right):
        return self._elements("oracle_binary", name, left, right)

    def power(self, versors, exponents):
        numbers = np.zeros((len(versors), BLADES))
        numbers[:, 0] = exponents
        return self.binary("power", versors, numbers)

    def construct(self, name, numbers):
        """A function of CONSTRUCTORS in objects_oracle.cpp; one row of parameters per object."""
        return self.construct_with_reasons(name, numbers)[0]

    def construct_with_reasons(self, name, numbers):
        return self._elements("oracle_construct", name, numbers)

    def incidence(self, name, left, right):
        """A function of INCIDENCE in objects_oracle.cpp, such as meet and join."""
        return self.incidence_with_reasons(name, left, right)[0]

    def incidence_with_reasons(self, name, left, right):
        return self._elements("oracle_incidence", name, left, right)

    def classify(self, elements, ipns=False):
        """The result of cga::classify for each element, as a dict of the properties that apply."""
        rows = self._call("oracle_classify", CLASS_NUMBERS, np.float64, elements, choice=int(ipns))
        return [classification(row) for row in rows]

    def motor(self, poses):
        return self._call("oracle_motor", BLADES, np.float64, poses)

    def extract(self, motors):
        return self._call("oracle_extract", POSE_NUMBERS, np.float64, motors)

    def exp_of_log(self, logs, kind):
        return self._call("oracle_exp_" + suffix(kind), POSE_NUMBERS, kind, logs)

    def log_of_pose(self, poses, kind):
        return self._call("oracle_log_" + suffix(kind), LOG_NUMBERS, kind, poses)

    def power_of_pose(self, poses, exponents, kind):
        return self._call("oracle_power_" + suffix(kind), POSE_NUMBERS, kind, poses, exponents)

    def interpolate(self, mode, begin, end, weights, kind):
        name = "oracle_interpolate_" + suffix(kind)
        return self._call(name, POSE_NUMBERS, kind, begin, end, weights, choice=MODES.index(mode))

    def interpolate_blocks(self, mode, begin, end, weights):
        name = "oracle_interpolate_blocks"
        return self._call(name, ROW_NUMBERS, np.float32, begin, end, weights, choice=MODES.index(mode))

    def to_json(self, element):
        return self._written("oracle_to_json", element)

    def to_text(self, element, null_basis):
        return self._written("oracle_to_text", element, ctypes.c_bool(null_basis))

    def to_latex(self, element, null_basis):
        return self._written("oracle_to_latex", element, ctypes.c_bool(null_basis))

    def from_json(self, text):
        """(32 numbers, None) or (None, the error)."""
        return self._read("oracle_from_json", text)

    def evaluate(self, text):
        """Evaluates an expression without variables: (32 numbers, None) or (None, the error)."""
        return self._read("oracle_evaluate", text)

    def _written(self, name, element, *choices):
        numbers = np.ascontiguousarray(element, np.float64)
        buffer = ctypes.create_string_buffer(TEXT_SIZE)
        function = getattr(self._library, name)
        function.restype = None
        function(pointer(numbers), *choices, buffer, ctypes.c_size_t(TEXT_SIZE))
        return buffer.value.decode()

    def _read(self, name, text):
        data = text.encode() if isinstance(text, str) else text
        numbers, error = np.empty(BLADES), ctypes.create_string_buffer(TEXT_SIZE)
        function = getattr(self._library, name)
        function.restype = ctypes.c_bool
        if function(data, ctypes.c_size_t(len(data)), pointer(numbers), error, ctypes.c_size_t(TEXT_SIZE)):
            return numbers, None
        return None, error.value.decode(errors="replace")

    def _call(self, name, width, kind, *inputs, choice=None):
        """Calls a function; returns `width` numbers for each row of the inputs."""
        arrays = [np.ascontiguousarray(array, kind) for array in inputs]
        count = len(arrays[0])
        result = np.full((count, width), np.nan, kind)
        first = [] if choice is None else [ctypes.c_int(choice)]
        function = getattr(self._library, name)
        function.restype = None
        function(*first, *map(pointer, [*arrays, result]), ctypes.c_size_t(count))
        return result

    def _elements(self, function_name, name, *inputs, width=BLADES):
        """Calls a function by its name in a table."""
        arrays = [np.ascontiguousarray(array, np.float64) for array in inputs]
        count = len(arrays[0])
        result = np.full((count, width), np.nan)
        reasons = (ctypes.c_char_p * count)()
        function = getattr(self._library, function_name)
        function.restype = ctypes.c_bool
        if not function(name.encode(), *map(pointer, [*arrays, result]), reasons, ctypes.c_size_t(count)):
            raise KeyError(f"{function_name} has no function '{name}'")
        return result, [reason.decode() if reason is not None else None for reason in reasons]


def classification(row):
    found = {"kind": KINDS[int(row[0])], "ipns": bool(row[1]), "imaginary": bool(row[2])}
    for name, numbers in CLASS_PARTS.items():
        if not np.isnan(row[numbers]).all():
            found[name] = row[numbers] if len(row[numbers]) > 1 else row[numbers][0]
    if not np.isnan(row[15:]).all():
        found["points"] = [row[15:18], row[18:21]]
    return found


def pointer(array):
    return array.ctypes.data_as(ctypes.c_void_p)


def suffix(kind):
    return {np.float64: "double", np.float32: "float"}[kind]
