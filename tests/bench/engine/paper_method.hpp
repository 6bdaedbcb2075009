#pragma once

#include "cga/motor/pose.hpp"
#include "paper_element.hpp"

#include <cstddef>
#include <vector>

// The GA-Unity paper's method for each object in each frame, operation by operation as in its public code, in C++:
//
//   TR = (1 - a) TR1 + a TR2                      15 coefficients
//   R = TR without e4 and e5                      the quaternion is that of e123 R
//   T = normalized (TR R~)                        X / sqrt(|(X conj(X))_0|)
//   t = -2 (normalized T . -e_o)                  the vector part
//
// which is 4 full geometric products, one inner product, and 14 multivectors taken and returned. The scale is blended
// separately. The errors of its code (the component order of quaternions, the weight of the dilator, q and -q) are corrected
// here: the ends are on one hemisphere, and TR has no dilator.

namespace bench::paper {

/// The two ends, as its Start() computes them.
struct Ends {
	Ends(const cga::Pose<float> &from, const cga::Pose<float> &to);

	Element from;
	Element to;
	float from_scale;
	float to_scale;
};

/// The pose of one object in one frame.
template <class Store>
[[nodiscard]] cga::Pose<float> interpolate(const Ends &ends, float weight, Store &store);

extern template cga::Pose<float> interpolate(const Ends &, float, Pool &);
extern template cga::Pose<float> interpolate(const Ends &, float, Allocating &);

} // namespace bench::paper
