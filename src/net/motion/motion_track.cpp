#include "net/motion/motion_track.hpp"

#include <algorithm>

namespace net {

namespace {

/// Segments that are mostly enough: of two windows, with some bends.
constexpr std::size_t USUAL = 8;

} // namespace

void MotionTrack::add(const BodyMotion &motion) {
	while (motions_.size() > first_ && motions_.back().segment.begin >= motion.segment.begin && (motion.appears || motion.vanishes || !motions_.back().appears)) {
		motions_.pop_back();
	}
	if (motions_.size() - first_ >= MOST) {
		++first_;
	}
	if (motions_.capacity() == 0) {
		motions_.reserve(USUAL);
	}
	if (motions_.size() == motions_.capacity() && first_ > 0) {
		// Room for the new one is where forgotten ones are.
		motions_.erase(motions_.begin(), motions_.begin() + std::ptrdiff_t(first_));
		first_ = 0;
	}
	motions_.push_back(motion);
}

void MotionTrack::forget_before(double tick) {
	while (first_ + 1 < motions_.size() && motions_[first_ + 1].segment.begin <= tick) {
		++first_;
	}
}

bool MotionTrack::pose_at(double tick, cga::Pose<double> &pose) const {
	std::size_t at = motions_.size();
	while (at > first_ && motions_[at - 1].segment.begin > tick) {
		--at;
	}
	if (at == first_) {
		// Before all that is known: a body that does not appear later was there.
		if (is_empty() || motions_[first_].appears || motions_[first_].vanishes) {
			return false;
		}
		at = first_ + 1;
	}
	const BodyMotion &motion = motions_[at - 1];
	if (motion.vanishes) {
		return false;
	}
	pose = motion.segment.pose_at(tick);
	return true;
}

bool MotionTrack::is_over(double tick) const {
	return is_empty() || (motions_.back().vanishes && motions_.back().segment.begin <= tick);
}

} // namespace net
