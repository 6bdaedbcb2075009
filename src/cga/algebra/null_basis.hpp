#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/vector.hpp"

// The vectors of conformal geometry: Euclidean vectors, the null vectors e_inf and e_o, and points.

namespace cga {

// e_inf = e4 + e5: the point at infinity.
[[nodiscard]] Multivector e_infinity();
// e_o = (e5 - e4) / 2: the origin; e_o . e_inf = -1.
[[nodiscard]] Multivector e_origin();
// x e1 + y e2 + z e3.
[[nodiscard]] Multivector euclidean(const Vector3<double> &vector);

// The conformal point x + (1/2) x^2 e_inf + e_o.
[[nodiscard]] Multivector point(const Vector3<double> &position);
// The position of a point of any weight: x / (-e_inf . X). Empty if it is not finite.
[[nodiscard]] std::optional<Vector3<double>> position_of(const Multivector &point);

} // namespace cga
