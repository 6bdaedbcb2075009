#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/vector.hpp"

// The vectors that conformal geometry is written in: e1, e2, e3 for directions, and two null ones.

namespace cga {

// e_inf = e4 + e5: the point at infinity.
[[nodiscard]] Multivector e_infinity();
// e_o = (e5 - e4) / 2: the origin; e_o . e_inf = -1.
[[nodiscard]] Multivector e_origin();
// The Euclidean vector x e1 + y e2 + z e3.
[[nodiscard]] Multivector euclidean(const Vector3<double> &vector);

} // namespace cga
