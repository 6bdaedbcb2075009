#pragma once

#include "cga/motor/interpolate.hpp"

#include <cstdint>

namespace net {

/// One segment of a body's motion. With u from 0 to 1 and w = u (1 - u), the pose is the motor T(u) R(u) D(u) of
///
///   translation  start + displacement u + translation_curvature w
///   rotation     start exp(rotation u + rotation_curvature w)       (rotation vectors in the body's axes at the start)
///   scale        start scale_ratio^u
///
/// In the modes LINEAR and SCREW, cga::interpolate gives the path from start to end, and the curvature terms are added to it.
struct MotionSegment {
	double begin = 0.0; ///< ticks
	double length = 1.0; ///< ticks
	cga::Pose<double> start;
	double scale_ratio = 1.0; ///< scale at the end divided by scale at the start
	cga::Vector3<double> displacement{ 0.0 };
	cga::Vector3<double> translation_curvature{ 0.0 };
	cga::Vector3<double> rotation{ 0.0 };
	cga::Vector3<double> rotation_curvature{ 0.0 };
	cga::Mode mode = cga::Mode::SEPARATE;

	[[nodiscard]] double end() const { return begin + length; }
	/// The pose at a time in ticks, which is clamped to the segment.
	[[nodiscard]] cga::Pose<double> pose_at(double time) const;
};

} // namespace net
