#pragma once

#include "cga/motor/interpolate.hpp"
#include "net/coding/portable_math.hpp"
#include "net/coding/rotation_vector.hpp"

#include <algorithm>
#include <cmath>
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
	[[nodiscard]] cga::Pose<double> pose_at(double time) const {
		const double u = std::clamp((time - begin) / length, 0.0, 1.0);
		const double w = u * (1.0 - u);
		cga::Pose<double> pose = start;
		if (scale_ratio != 1.0) {
			pose.scale *= portable_exp2(u * portable_log2(scale_ratio));
		}
		if (mode == cga::Mode::SEPARATE) {
			pose.translation += displacement * u + translation_curvature * w;
			pose.rotation = start.rotation * exp_rotation(rotation * u + rotation_curvature * w);
			return pose;
		}
		cga::Pose<double> end = start;
		end.translation += displacement;
		end.rotation = start.rotation * exp_rotation(rotation);
		end.scale *= scale_ratio;
		const double scale = pose.scale;
		pose = cga::interpolate(start, end, u, mode);
		pose.translation += translation_curvature * w;
		pose.rotation = pose.rotation * exp_rotation(rotation_curvature * w);
		pose.scale = scale;
		return pose;
	}
};

/// A decoded segment of one body's motion. From segment.begin on, the body follows the segment and then rests at its end,
/// unless it vanishes.
struct BodyMotion {
	uint32_t id = 0;
	bool appears = false; ///< the body is new or jumps: playback does not interpolate from its last pose
	bool jumps = false; ///< it appears, but is not new
	bool vanishes = false; ///< the body does not exist from segment.begin on
	bool freed = false; ///< it vanishes because its object was freed
	MotionSegment segment;
	uint64_t life = 0; ///< number of the body's life, assigned by the receiver; of a body that vanishes, the life that ends

	/// The body is at rest at `pose` from `begin` on.
	[[nodiscard]] static BodyMotion rest(uint32_t id, double begin, const cga::Pose<double> &pose, bool appears) { return { id, appears, false, false, false, { begin, 1.0, pose } }; }
	/// The body does not exist from `begin` on.
	[[nodiscard]] static BodyMotion removal(uint32_t id, double begin, bool freed = false) { return { id, false, false, true, freed, { begin, 1.0, {} } }; }
};

} // namespace net
