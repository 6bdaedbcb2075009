#pragma once

#include "cga/algebra/blade.hpp"

// Which coefficients of a multivector the quaternions of a motor's minimal form (motor.hpp) pack.

namespace cga {

// The coefficients of a quaternion of the minimal form, in its order (w, x, y, z), of A and B: half their sum is the
// coefficient of `euclidean`, half their difference that of `with_e45`, each with the sign of the packing.
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

// The coefficients of V in its order (w, x, y, z): those with e4 and with e5 are equal in a motor.
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
