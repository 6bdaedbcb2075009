#pragma once

#include "net/motion/motion_segment.hpp"

#include <cstdint>

namespace net {

/// A decoded piece of one body's motion: from segment.begin on the body follows the segment and then stays at its end, or
/// it is gone.
struct BodyMotion {
	uint32_t id = 0;
	bool appears = false; ///< the body is new, or jumps: playback does not interpolate from its last pose to the segment
	bool vanishes = false; ///< the body does not exist from segment.begin on
	MotionSegment segment;
};

} // namespace net
