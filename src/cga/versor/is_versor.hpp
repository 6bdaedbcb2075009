#pragma once

#include "cga/algebra/multivector.hpp"

namespace cga {

// Whether `x` is a product of non-null vectors. In five dimensions, it is one if it is even or odd and X X~ is a nonzero scalar.
// `tolerance` is relative to X X~. Nonzero scalars are versors, null blades are not.
[[nodiscard]] bool is_versor(const Multivector &x, double tolerance = 1e-10);

// Whether `x` is a motor T R D of positive scale and any weight but zero, as to_motor() accepts it.
[[nodiscard]] bool is_motor(const Multivector &x, double tolerance = 1e-9);

} // namespace cga
