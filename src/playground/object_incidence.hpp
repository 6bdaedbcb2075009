#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/result.hpp"

// What blades have to do with each other as subspaces: OPNS, blades only, else an error.
//
// With a, b the grades of A and B and g the top grade of A B, the join has grade (a + b + g) / 2 and the meet
// (a + b - g) / 2, meet = (A J^-1) lc B. All of this is the same in any metric and is computed in the Euclidean one,
// where no blade is null. Parts below 1e-9 of |A| |B| count as zero, so objects should be near the origin compared with
// their distances from each other.

namespace playground {

// Of coefficients of the size of A's and B's; the scalar 1 where they have nothing in common but zero.
[[nodiscard]] cga::Result<cga::Multivector> meet(const cga::Multivector &a, const cga::Multivector &b);
// The blade of unit size that contains both.
[[nodiscard]] cga::Result<cga::Multivector> join(const cga::Multivector &a, const cga::Multivector &b);
// (X lc B) B^-1
[[nodiscard]] cga::Result<cga::Multivector> project_onto(const cga::Multivector &x, const cga::Multivector &onto);
// X minus its projection.
[[nodiscard]] cga::Result<cga::Multivector> reject_from(const cga::Multivector &x, const cga::Multivector &from);
// The versor dual(B) applied to X, so that points keep their weight: the mirror image in a plane, an inversion in a
// sphere, half a turn about a line or a circle, the reflection in a point.
[[nodiscard]] cga::Result<cga::Multivector> reflect_in(const cga::Multivector &x, const cga::Multivector &mirror);

} // namespace playground
