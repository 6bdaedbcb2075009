#pragma once

#include "cga/versor/study_number.hpp"

// h(c) = arccos(c) / sqrt(1 - c^2), the function behind the logarithm of versors: with M = cosh(B) + sinh(B),
// log(M) = sinh(B) h(cosh(B)). It is analytic except on the real axis up to -1; beyond 1 it is
// arcosh(c) / sqrt(c^2 - 1), and h(1) = 1.

namespace cga {

// h of a real c > -1.
[[nodiscard]] double arccosine_ratio(double c);
// h of the Study number c + W with W^2 = `w_squared`; c >= 0, and c - |W| > -1 if W^2 > 0.
[[nodiscard]] StudyNumber arccosine_ratio(double c, double w_squared);

} // namespace cga
