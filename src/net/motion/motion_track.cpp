#include "net/motion/motion_track.hpp"

#include <algorithm>

namespace net {

namespace {

/// Segments that are mostly enough: of two windows, with some bends.
constexpr size_t USUAL = 8;

} // namespace

void MotionTrack::add(const BodyMotion &motion) {
	while (_motions.size() > _first && _motions.back().segment.begin >= motion.segment.begin && (motion.appears || motion.vanishes || !_motions.back().appears)) {
		_motions.pop_back();
	}
	if (_motions.size() - _first >= MOST) {
		++_first;
	}
	if (_motions.capacity() == 0) {
		_motions.reserve(USUAL);
	}
	if (_motions.size() == _motions.capacity() && _first > 0) {
		// Room for the new one is where forgotten ones are.
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

bool MotionTrack::pose_at(double tick, cga::Pose<double> &pose) const {
	size_t at = _motions.size();
	while (at > _first && _motions[at - 1].segment.begin > tick) {
		--at;
	}
	if (at == _first) {
		// Before all that is known: a body that does not appear later was there.
		if (is_empty() || _motions[_first].appears || _motions[_first].vanishes) {
			return false;
		}
		at = _first + 1;
	}
	const BodyMotion &motion = _motions[at - 1];
	if (motion.vanishes) {
		return false;
	}
	pose = motion.segment.pose_at(tick);
	return true;
}

bool MotionTrack::is_over(double tick) const {
	return is_empty() || (_motions.back().vanishes && _motions.back().segment.begin <= tick);
}

} // namespace net
