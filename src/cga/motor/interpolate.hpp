#pragma once

#include "cga/motor/pose.hpp"

namespace cga {

// How the poses between two poses are chosen.
enum class Mode {
	LINEAR, // blend of the 8 motor coefficients (the GA-Unity paper's method with the hemisphere rule); scale by itself
	SCREW, // the power of the motion from one to the other: constant twist, geometric in scale
	SEPARATE, // lerp of translation, slerp of rotation, lerp of scale, as engines do
};

// The pose at `weight` of the way from `from` (0) to `to` (1), turning the short way round.
//
// - Weights 0 and 1 give the end poses themselves. SCREW goes on with the same twist outside 0..1;
//   LINEAR and SEPARATE clamp the weight.
// - Rotations are normalised on entry (within rounding of unit length they keep their bits; a zero one counts
//   as the identity). q and -q mean the same and give the same path. Exactly 180 degrees apart, both ways are
//   equally short: the one of the quaternions' own signs is taken.
// - Scales are positive by contract. If one is not, SCREW blends scale linearly beside the rigid screw.
// - Finite input gives finite output. Where a result would leave the range of T (extrapolation far out, double
//   scales more than 1e308 apart), the end pose nearer in weight is returned.
// - Computed in double for either T, relative to `from`: precision does not depend on the distance from the origin.
template <class T>
[[nodiscard]] Pose<T> interpolate(const Pose<T> &from, const Pose<T> &to, T weight, Mode mode) noexcept;

extern template Pose<float> interpolate(const Pose<float> &, const Pose<float> &, float, Mode) noexcept;
extern template Pose<double> interpolate(const Pose<double> &, const Pose<double> &, double, Mode) noexcept;

} // namespace cga
