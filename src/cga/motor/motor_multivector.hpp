#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/motor/motor.hpp"
#include "cga/motor/motor_exp.hpp"

// Between the minimal form of a motor and the general multivector.

namespace cga {

[[nodiscard]] Multivector to_multivector(const Motor<double> &motor);
// The bivector -(1/2) (w1 e23 - w2 e13 + w3 e12 + v e_inf + sigma E).
[[nodiscard]] Multivector to_multivector(const MotorLog<double> &log);
// Empty unless `x` is a motor with positive scale, of any weight: even, within the twelve coefficients, M M~ a
// positive number; each within `tolerance` relative to the size of the coefficients that it is made of.
[[nodiscard]] std::optional<Motor<double>> to_motor(const Multivector &x, double tolerance = 1e-9);

// The bivector L of a motor back in its parts. Empty unless `bivector` is within the seven coefficients that it needs:
// the rest within `tolerance` relative to the largest, those with e4 and e5 equal within `tolerance` relative to them.
[[nodiscard]] std::optional<MotorLog<double>> to_motor_log(const Multivector &bivector, double tolerance = 1e-9);

} // namespace cga
