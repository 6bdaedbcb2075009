#include "net/motion/motion_track.hpp"

#include <algorithm>

namespace net {

void MotionTrack::add(const BodyMotion &motion) {
	while (_motions.size() > _first && _motions.back().segment.begin >= motion.segment.begin && (motion.appears || motion.vanishes || !_motions.back().appears)) {
		_motions.pop_back();
	}
	if (_motions.size() - _first >= MAX_SEGMENTS) {
		++_first;
	}
	if (_motions.capacity() == 0) {
		_motions.reserve(8); // typically two windows of a few segments each
	}
	if (_motions.size() == _motions.capacity() && _first > 0) {
		// Reuse the memory of dropped segments.
		_motions.erase(_motions.begin(), _motions.begin() + ptrdiff_t(_first));
		_first = 0;
	}
	_motions.push_back(motion);
}

void MotionTrack::forget_before(double tick) {
	while (_first + 1 < _motions.size() && _motions[_first + 1].segment.begin <= tick) {
		++_first;
	}
}

std::optional<cga::Pose<double>> MotionTrack::pose_at(double tick) const {
	size_t at = _motions.size();
	while (at > _first && _motions[at - 1].segment.begin > tick) {
		--at;
	}
	if (at == _first) {
		// `tick` is before all known motion. The body existed then, unless it appears later.
		if (is_empty() || _motions[_first].appears || _motions[_first].vanishes) {
			return std::nullopt;
		}
		at = _first + 1;
	}
	const BodyMotion &motion = _motions[at - 1];
	return motion.vanishes ? std::nullopt : std::optional(motion.segment.pose_at(tick));
}

} // namespace net
