#pragma once

#include "cga/algebra/blade.hpp"

// The multivector coefficients that the quaternions of a motor's minimal form (motor.hpp) pack.

namespace cga {

// For each component (w, x, y, z) of a and b: half the sum is the coefficient of `euclidean`, half the difference that of
// `with_e45`, both times `sign`.
struct PackedPair {
	int euclidean;
	int with_e45;
	double sign;
};

inline constexpr PackedPair MOTOR_PAIRS[4] = {
	{ 0, E45, 1.0 },
	{ E23, E2345, -1.0 },
	{ E13, E1345, 1.0 },
	{ E12, E1245, -1.0 },
};

// For each component (w, x, y, z) of v: its two coefficients, equal in a motor.
struct NullPair {
	int with_e4;
	int with_e5;
};

inline constexpr NullPair MOTOR_NULL_PAIRS[4] = {
	{ E1234, E1235 },
	{ E14, E15 },
	{ E24, E25 },
	{ E34, E35 },
};

} // namespace cga
