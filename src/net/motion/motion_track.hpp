#pragma once

#include "net/stream/stream_decoder.hpp"

#include <cstddef>
#include <vector>

namespace net {

/// The jitter buffer of one body: the segments of its motion from the one that is shown on, in order of time.
class MotionTrack {
public:
	/// Segments kept at most; what is shown is moved on if more arrive.
	static constexpr size_t MOST = 4 * MAX_TICKS;

	/// Appends what is new; what was known from its begin on is replaced.
	void add(const BodyMotion &motion);
	/// Forgets what lies before the segment that is shown at `tick`.
	void forget_before(double tick);
	/// The pose at a time, in ticks. False if the body is not there.
	bool pose_at(double tick, cga::Pose<double> &pose) const;
	/// True if the body is not there at `tick`, nor later.
	[[nodiscard]] bool is_over(double tick) const;
	[[nodiscard]] bool is_empty() const { return _motions.size() == _first; }

private:
	std::vector<BodyMotion> _motions; // those before _first are forgotten
	size_t _first = 0;
};

} // namespace net
