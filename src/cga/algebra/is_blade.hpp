#pragma once

#include "cga/algebra/multivector.hpp"

namespace cga {

// The grade of `x` if its parts of all other grades are at most `tolerance` times max_abs. Empty for mixed grades, zero, and
// elements that are not finite.
[[nodiscard]] std::optional<int> single_grade(const Multivector &x, double tolerance = 1e-10);

// Whether `x` is an outer product of vectors: of one grade, and of grades 2 and 3 only if X ^ X = 0 (of grade 3 for
// its dual) within `tolerance` times max_abs squared. Null blades are blades, and so is every scalar.
[[nodiscard]] bool is_blade(const Multivector &x, double tolerance = 1e-10);

} // namespace cga
