"""The C++ algebra, by its C interface (cga_oracle.cpp), on numpy arrays."""

import ctypes

import numpy as np

BLADES = 32
PRODUCTS = ["geometric", "outer", "inner", "left contraction", "right contraction", "scalar"]
OPERATIONS = ["reverse", "grade involution", "clifford conjugate", "dual", "undual", "norm squared", "inverse"]
MODES = ["LINEAR", "SCREW", "SEPARATE"]

POSE_NUMBERS = 8  # t1 t2 t3 qw qx qy qz s
LOG_NUMBERS = 7  # w1 w2 w3 v1 v2 v3 sigma
ROW_NUMBERS = 12  # a 3 x 4 matrix, row by row


class Library:
    """Every function takes and returns arrays with one element a row."""

    def __init__(self, path):
        self._library = ctypes.CDLL(path)

    def _call(self, name, width, kind, *inputs, choice=None):
        """Calls oracle_NAME and returns its result: `width` numbers for each row of the inputs."""
        arrays = [np.ascontiguousarray(array, kind) for array in inputs]
        count = len(arrays[0])
        result = np.full((count, width), np.nan, kind)
        pointers = [array.ctypes.data_as(ctypes.c_void_p) for array in [*arrays, result]]
        first = [] if choice is None else [ctypes.c_int(choice)]
        function = getattr(self._library, name)
        function.restype = None
        function(*first, *pointers, ctypes.c_size_t(count))
        return result

    def product(self, name, left, right):
        return self._call("oracle_product", BLADES, np.float64, left, right, choice=PRODUCTS.index(name))

    def operation(self, name, operands):
        return self._call("oracle_operation", BLADES, np.float64, operands, choice=OPERATIONS.index(name))

    def sandwich(self, versors, operands):
        return self._call("oracle_sandwich", BLADES, np.float64, versors, operands)

    def motor(self, poses):
        return self._call("oracle_motor", BLADES, np.float64, poses)

    def extract(self, motors):
        return self._call("oracle_extract", POSE_NUMBERS, np.float64, motors)

    def exp(self, logs, kind):
        return self._call("oracle_exp_" + suffix(kind), POSE_NUMBERS, kind, logs)

    def log(self, poses, kind):
        return self._call("oracle_log_" + suffix(kind), LOG_NUMBERS, kind, poses)

    def power(self, poses, exponents, kind):
        return self._call("oracle_power_" + suffix(kind), POSE_NUMBERS, kind, poses, exponents)

    def interpolate(self, mode, begin, end, weights, kind):
        name = "oracle_interpolate_" + suffix(kind)
        return self._call(name, POSE_NUMBERS, kind, begin, end, weights, choice=MODES.index(mode))

    def interpolate_blocks(self, mode, begin, end, weights):
        name = "oracle_interpolate_blocks"
        return self._call(name, ROW_NUMBERS, np.float32, begin, end, weights, choice=MODES.index(mode))


def suffix(kind):
    return {np.float64: "double", np.float32: "float"}[kind]
