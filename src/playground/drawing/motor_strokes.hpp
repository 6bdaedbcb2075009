#pragma once

#include "cga/motor/pose.hpp"
#include "playground/drawing/figure.hpp"

#include <optional>

// How a motor moves things: a frame at the origin that it carries along, the path of that frame, and around the axis a
// helix with the motor's angle and pitch.

namespace playground::drawing {

// Of what the motor turns about; through the point that it leaves alone if it scales.
struct MotorAxis {
	Vector point;
	Vector direction;
};
// Empty of a motor that does not turn.
[[nodiscard]] std::optional<MotorAxis> axis_of(const cga::Pose<double> &pose);
// The point that a motor leaves in place, if it scales.
[[nodiscard]] std::optional<Vector> fixed_point_of(const cga::Pose<double> &pose);

[[nodiscard]] Strokes motor_strokes(const cga::Pose<double> &pose);

inline constexpr double FRAME_SIZE = 0.5; // metres
inline constexpr double HELIX_RADIUS = 0.65; // metres
inline constexpr int PATH_STEPS = 48;

} // namespace playground::drawing
