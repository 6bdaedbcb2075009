#pragma once

#include "cga/algebra/null_basis.hpp"

// The factors of a motor T R D, as general multivectors.

namespace cga {

// T = 1 - (1/2) t e_inf.
[[nodiscard]] Multivector translator(const Vector3<double> &offset);
// R = w - z e12 + y e13 - x e23; `rotation` of unit length.
[[nodiscard]] Multivector rotor(const Quaternion<double> &rotation);
// D = cosh(g/2) - sinh(g/2) E with scale = exp(g) > 0.
[[nodiscard]] Multivector dilator(double scale);

} // namespace cga
