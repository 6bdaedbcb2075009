#pragma once

#include "cga/algebra/multivector.hpp"

namespace cga {

// Whether `x` is a product of vectors that are not null: even or odd, with X X~ a number other than zero, which is sufficient in
// five dimensions. `tolerance` is relative to X X~. Numbers other than zero are versors, null blades are not.
[[nodiscard]] bool is_versor(const Multivector &x, double tolerance = 1e-10);

// Whether `x` is a motor T R D of positive scale and any weight but zero, as to_motor() accepts it.
[[nodiscard]] bool is_motor(const Multivector &x, double tolerance = 1e-9);

} // namespace cga
