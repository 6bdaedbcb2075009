#pragma once

#include "cga/motor/pose.hpp"

namespace cga {

// How to interpolate between two poses.
enum class Mode {
	LINEAR, // blend of the 8 motor coefficients (the GA-Unity paper's method with the hemisphere rule); scale lerped separately
	SCREW, // the power of the motion from one to the other: constant twist, geometric in scale
	SEPARATE, // lerp of translation, slerp of rotation, lerp of scale, as engines do
};

// The pose at `weight` between `from` (0) and `to` (1), along the shorter rotation.
//
// - Weights 0 and 1 return the end poses. Outside 0..1, SCREW extrapolates the same twist; LINEAR and SEPARATE clamp.
// - Rotations are normalized first (those of unit length within rounding keep their bits; zero counts as the identity).
//   q and -q give the same path. If the poses are exactly 180 degrees apart, the signs of the quaternions decide.
// - Scales must be positive. If one is not, SCREW lerps the scale and moves along the rigid screw.
// - Finite input gives finite output. If a result would leave the range of T (extreme extrapolation, double scales more
//   than 1e308 apart), the end pose nearer in weight is returned.
// - Computed in double for either T, relative to `from`: precision does not depend on the distance from the origin.
template <class T>
[[nodiscard]] Pose<T> interpolate(const Pose<T> &from, const Pose<T> &to, T weight, Mode mode) noexcept;

extern template Pose<float> interpolate(const Pose<float> &, const Pose<float> &, float, Mode) noexcept;
extern template Pose<double> interpolate(const Pose<double> &, const Pose<double> &, double, Mode) noexcept;

} // namespace cga
