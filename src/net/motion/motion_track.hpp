#pragma once

#include "net/motion/motion_code.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace net {

/// The jitter buffer of one body: its segments in chronological order, starting with the one being shown.
class MotionTrack {
public:
	/// Maximum number of segments. If more arrive, the oldest is dropped.
	static constexpr size_t MAX_SEGMENTS = size_t(4) * MAX_TICKS;

	/// Appends a motion and discards known motion that begins at the same time or later.
	void add(const BodyMotion &motion);
	/// Drops the segments before the one shown at `tick`.
	void forget_before(double tick);
	/// The pose at `tick`. Returns std::nullopt if the body does not exist then.
	[[nodiscard]] std::optional<cga::Pose<double>> pose_at(double tick) const;
	/// True if the body exists neither at `tick` nor later.
	[[nodiscard]] bool is_over(double tick) const { return is_empty() || (_motions.back().vanishes && _motions.back().segment.begin <= tick); }
	[[nodiscard]] bool is_empty() const { return _motions.size() == _first; }

private:
	std::vector<BodyMotion> _motions; // entries before _first are dropped
	size_t _first = 0;
};

} // namespace net
