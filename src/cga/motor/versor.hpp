#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/motor/pose.hpp"

// The null basis, points, and the versors that make a motor, as general multivectors.

namespace cga {

// e_inf = e4 + e5: the point at infinity.
[[nodiscard]] Multivector e_infinity();
// e_o = (e5 - e4) / 2: the origin; e_o . e_inf = -1.
[[nodiscard]] Multivector e_origin();
// The Euclidean vector x e1 + y e2 + z e3.
[[nodiscard]] Multivector euclidean(const Vector3<double> &vector);
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
