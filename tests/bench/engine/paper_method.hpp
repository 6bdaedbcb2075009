#pragma once

#include "cga/motor/pose.hpp"
#include "paper_element.hpp"

#include <cstddef>
#include <vector>

// The method of the GA-Unity paper for one object in one frame, operation by operation as in its public code:
//
//   TR = (1 - a) TR1 + a TR2                      15 coefficients
//   R = TR without e4 and e5                      read as a quaternion from e123 R
//   T = normalized(TR R~)                         normalized(X) = X / sqrt(|(X conj(X))_0|)
//   t = -2 (normalized(T) . -e_o)                 its vector part is the translation
//
// That is 4 full geometric products, one inner product and 14 multivectors. The scale is interpolated separately. Three
// mistakes of the public code are corrected here: the order of a quaternion's components, the weight of the dilator (TR
// is made without one), and the choice between q and -q (both ends are on one hemisphere).

namespace bench::paper {

/// The two poses, prepared as in the public code's Start().
struct Ends {
	Ends(const cga::Pose<float> &from, const cga::Pose<float> &to);

	Element from;
	Element to;
	float from_scale;
	float to_scale;
};

/// The pose at `weight` (0 to 1). Multivectors come from `store`, a Pool or Allocating.
template <class Store>
[[nodiscard]] cga::Pose<float> interpolate(const Ends &ends, float weight, Store &store);

extern template cga::Pose<float> interpolate(const Ends &, float, Pool &);
extern template cga::Pose<float> interpolate(const Ends &, float, Allocating &);

} // namespace bench::paper
