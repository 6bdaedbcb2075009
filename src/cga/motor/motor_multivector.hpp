#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/motor/motor.hpp"
#include "cga/motor/motor_exp.hpp"

// Conversions between the minimal form of a motor and the general multivector.

namespace cga {

[[nodiscard]] Multivector to_multivector(const Motor<double> &motor);
// The bivector -(1/2) (w1 e23 - w2 e13 + w3 e12 + v e_inf + sigma E).
[[nodiscard]] Multivector to_multivector(const MotorLog<double> &log);
// Empty unless `x` is a motor of positive scale and any weight: even, with the twelve coefficients only, and M M~ a positive
// number; each within `tolerance`, relative to the coefficients it is computed from.
[[nodiscard]] std::optional<Motor<double>> to_motor(const Multivector &x, double tolerance = 1e-9);

// The parts of the bivector L of a motor. Empty unless all other coefficients are zero within `tolerance` times the largest
// one, and those with e4 and e5 equal within `tolerance` relative to themselves.
[[nodiscard]] std::optional<MotorLog<double>> to_motor_log(const Multivector &bivector, double tolerance = 1e-9);

} // namespace cga
