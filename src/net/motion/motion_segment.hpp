#pragma once

#include "cga/motor/interpolate.hpp"

#include <cstdint>

namespace net {

/// The motion of one body over some ticks. With u from 0 to 1 and w = u (1 - u):
///
///   translation  from + way u + way_bend w
///   rotation     from exp(turn u + turn_bend w)        (rotation vectors in the frame of the start)
///   scale        geometric
///
/// which is the motor T(u) R(u) D(u). In the modes LINEAR and SCREW the part without the bends is cga::interpolate's
/// path from start to end instead, and the bends are applied to it.
struct MotionSegment {
	double begin = 0.0; ///< ticks
	double length = 1.0; ///< ticks
	cga::Pose<double> from;
	double scale_ratio = 1.0; ///< of the end's scale to the start's
	cga::Vector3<double> displacement{ 0.0 };
	cga::Vector3<double> translation_curvature{ 0.0 };
	cga::Vector3<double> turn{ 0.0 };
	cga::Vector3<double> rotation_curvature{ 0.0 };
	cga::Mode mode = cga::Mode::SEPARATE;

	[[nodiscard]] double end() const { return begin + length; }
	/// The pose at a time in ticks; before the begin that of the begin, after the end that of the end.
	[[nodiscard]] cga::Pose<double> pose_at(double time) const;
};

} // namespace net
