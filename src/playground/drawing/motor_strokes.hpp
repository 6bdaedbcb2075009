#pragma once

#include "cga/motor/pose.hpp"
#include "playground/drawing/figure.hpp"

#include <optional>

// Drawing of a motor: a coordinate frame at the origin and its image, the path between them, and a helix around the axis
// with the motor's angle and pitch.

namespace playground::drawing {

// The screw axis; it passes through the fixed point if the motor scales.
struct MotorAxis {
	Vector point;
	Vector direction;
};
// Empty if the motor does not rotate.
[[nodiscard]] std::optional<MotorAxis> axis_of(const cga::Pose<double> &pose);
// Empty if the motor does not scale.
[[nodiscard]] std::optional<Vector> fixed_point_of(const cga::Pose<double> &pose);

[[nodiscard]] Strokes motor_strokes(const cga::Pose<double> &pose);

inline constexpr double FRAME_SIZE = 0.5; // meters
inline constexpr double HELIX_RADIUS = 0.65; // meters
inline constexpr int PATH_STEPS = 48;

} // namespace playground::drawing
