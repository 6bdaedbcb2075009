#pragma once

#include "cga/algebra/multivector.hpp"

namespace cga {

// Whether `x` is a product of vectors that are not null: even or odd, and X X~ a number that is not zero. In five
// dimensions that is enough. `tolerance` is relative to X X~. Numbers but zero are versors, null blades are not.
[[nodiscard]] bool is_versor(const Multivector &x, double tolerance = 1e-10);

// Whether `x` is a motor T R D of any weight but zero, and of positive scale: what to_motor() takes.
[[nodiscard]] bool is_motor(const Multivector &x, double tolerance = 1e-9);

} // namespace cga
