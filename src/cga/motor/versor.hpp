#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/algebra/null_basis.hpp"
#include "cga/motor/pose.hpp"

// Points, and the versors that make a motor, as general multivectors.

namespace cga {

// The conformal point x + (1/2) x^2 e_inf + e_o.
[[nodiscard]] Multivector point(const Vector3<double> &position);
// The position of a point of any weight: x / (-e_inf . X). Empty for what has no finite position.
[[nodiscard]] std::optional<Vector3<double>> position_of(const Multivector &point);

// T = 1 - (1/2) t e_inf.
[[nodiscard]] Multivector translator(const Vector3<double> &offset);
// R = w - z e12 + y e13 - x e23; `rotation` of unit length.
[[nodiscard]] Multivector rotor(const Quaternion<double> &rotation);
// D = cosh(g/2) - sinh(g/2) E with scale = exp(g) > 0.
[[nodiscard]] Multivector dilator(double scale);

} // namespace cga
