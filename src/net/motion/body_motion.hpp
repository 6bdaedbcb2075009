#pragma once

#include "net/motion/motion_segment.hpp"

#include <cstdint>

namespace net {

/// A decoded segment of one body's motion. From segment.begin on, the body follows the segment and then rests at its end,
/// unless it vanishes.
struct BodyMotion {
	uint32_t id = 0;
	bool appears = false; ///< the body is new or jumps: playback does not interpolate from its last pose
	bool vanishes = false; ///< the body does not exist from segment.begin on
	MotionSegment segment;
};

} // namespace net
