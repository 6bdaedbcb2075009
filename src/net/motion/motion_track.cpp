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
	_life = motion.vanishes ? 0 : motion.life;
}

void MotionTrack::forget_before(double tick) {
	while (_first + 1 < _motions.size() && _motions[_first + 1].segment.begin <= tick) {
		++_first;
	}
}

void MotionTrack::restart() {
	_motions.clear();
	_first = 0;
}

size_t MotionTrack::end_at(double tick) const {
	size_t end = _motions.size();
	while (end > _first && _motions[end - 1].segment.begin > tick) {
		--end;
	}
	return end;
}

const BodyMotion *MotionTrack::motion_at(double tick) const {
	size_t end = end_at(tick);
	if (end == _first) {
		// `tick` is before all known motion. The body existed then, unless it appears later.
		if (is_empty() || _motions[_first].appears) {
			return nullptr;
		}
		end = _first + 1;
	}
	const BodyMotion &motion = _motions[end - 1];
	return motion.vanishes ? nullptr : &motion;
}

const BodyMotion *MotionTrack::first_motion(double tick, uint64_t min_life) const {
	const size_t begin = std::max(end_at(tick), _first + 1) - 1;
	for (size_t i = begin; i < _motions.size(); ++i) {
		if (!_motions[i].vanishes && _motions[i].life >= min_life) {
			return &_motions[i];
		}
	}
	return nullptr;
}

} // namespace net
