#pragma once

#include "cga/motor/pose.hpp"
#include "paper_element.hpp"

#include <cstddef>
#include <vector>

// What the GA-Unity paper does for each object in each frame, operation by operation as in its public code, in C++:
//
//   TR = (1 - a) TR1 + a TR2                      15 coefficients
//   R = TR without e4 and e5                      the quaternion is that of e123 R
//   T = normalised (TR R~)                        X / sqrt(|(X conj(X))_0|)
//   t = -2 (normalised T . -e_o)                  the vector part
//
// which is 4 full geometric products, one inner product, and 14 multivectors taken and given back. The scale is blended
// by itself. What its code gets wrong (the order of a quaternion's numbers, the weight of the dilator, q and -q) is right
// here: ends on one hemisphere, TR made without a dilator.

namespace bench::paper {

/// The two ends, as its Start() leaves them.
struct Ends {
	Ends(const cga::Pose<float> &from, const cga::Pose<float> &to);

	Element from;
	Element to;
	float from_scale;
	float to_scale;
};

/// One object in one frame.
template <class Store>
[[nodiscard]] cga::Pose<float> interpolate(const Ends &ends, float weight, Store &store);

extern template cga::Pose<float> interpolate(const Ends &, float, Pool &);
extern template cga::Pose<float> interpolate(const Ends &, float, Allocating &);

} // namespace bench::paper
