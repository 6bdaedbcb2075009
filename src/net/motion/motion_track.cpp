#include "net/motion/motion_track.hpp"

#include <algorithm>

namespace net {

namespace {

/// Usual capacity for a body that moves: two windows of a few segments each.
constexpr size_t MOVING_CAPACITY = 8;
/// Tracks of so many segments are common: their memory is kept for the next ones.
constexpr size_t USUAL_CAPACITY = 16;

} // namespace

void MotionTrack::add(const BodyMotion &motion, size_t max_capacity) {
	while (_motions.size() > _first && _motions.back().segment.begin >= motion.segment.begin && (motion.appears || motion.vanishes || !_motions.back().appears)) {
		_motions.pop_back();
	}
	if (_motions.size() - _first >= MAX_SEGMENTS) {
		++_first;
	}
	if (!_motions.empty() && _motions.size() == _motions.capacity()) {
		if (2 * _motions.capacity() > max_capacity) {
			_first = std::max(_first, _motions.size() / 2);
		}
		if (2 * _first >= _motions.size()) {
			drop_forgotten();
		} else if (!motion.vanishes && _motions.capacity() < MOVING_CAPACITY && MOVING_CAPACITY <= max_capacity) {
			_motions.reserve(MOVING_CAPACITY);
		}
	}
	_motions.push_back(motion);
	_life = motion.vanishes ? 0 : motion.life;
}

/// Reuses the memory of dropped segments.
void MotionTrack::drop_forgotten() {
	_motions.erase(_motions.begin(), _motions.begin() + ptrdiff_t(_first));
	_first = 0;
}

void MotionTrack::forget_before(double tick) {
	while (_first + 1 < _motions.size() && _motions[_first + 1].segment.begin <= tick) {
		++_first;
	}
	if (_motions.capacity() > USUAL_CAPACITY && 4 * (_motions.size() - _first) <= _motions.capacity()) {
		std::vector<BodyMotion> kept;
		kept.reserve(_motions.capacity() / 2);
		kept.assign(_motions.begin() + ptrdiff_t(_first), _motions.end());
		_motions.swap(kept);
		_first = 0;
	}
}

void MotionTrack::restart() {
	_motions.clear();
	_first = 0;
}

size_t MotionTrack::end_at(double tick) const {
	const auto begin = _motions.begin() + ptrdiff_t(_first);
	const auto end = std::upper_bound(begin, _motions.end(), tick, [](double time, const BodyMotion &motion) { return time < motion.segment.begin; });
	return size_t(end - _motions.begin());
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
