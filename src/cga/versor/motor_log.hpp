#pragma once

#include "cga/motor/motor_exp.hpp"
#include "cga/motor/motor_multivector.hpp"

// exp and log of motors as general multivectors, by motor_exp.hpp. The dilation is not computed from the scale or from a and b
// of Motor, which would lose digits of a dilation near 0.

namespace cga {

// exp(L), of unit weight. Not finite if it leaves the range of double.
[[nodiscard]] Multivector motor_exp(const MotorLog<double> &log);

struct WeightedMotorLog {
	MotorLog<double> log;
	double weight = 1.0; // sqrt(M M~)
};

// The parts of log(M), along the shorter rotation. Empty if `x` is not a motor within `tolerance`. This is stricter than
// to_motor(): coefficients that motors lack must be small relative to the translation, not only to the whole.
[[nodiscard]] std::optional<WeightedMotorLog> motor_log(const Multivector &x, double tolerance);

} // namespace cga
