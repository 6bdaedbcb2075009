#pragma once

#include "cga/motor/motor_exp.hpp"
#include "cga/motor/motor_multivector.hpp"

// exp and log between the general multivectors of motors and their bivectors. motor_exp.hpp does the work; the
// dilation does not pass through the scale, nor through Motor's a and b, where one near 0 would lose its digits.

namespace cga {

// exp(L), of unit weight. Not finite where it leaves the range of double.
[[nodiscard]] Multivector motor_exp(const MotorLog<double> &log);

struct WeightedMotorLog {
	MotorLog<double> log;
	double weight = 1.0; // sqrt(M M~)
};

// The parts of log(M) of the shorter way round. Empty if `x` is no motor within `tolerance`, as to_motor()
// has it and beyond: what is no motor's must be small beside the translation, not only beside the whole.
[[nodiscard]] std::optional<WeightedMotorLog> motor_log(const Multivector &x, double tolerance);

} // namespace cga
