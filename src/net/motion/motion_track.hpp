#pragma once

#include "net/motion/motion_code.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace net {

/// The jitter buffer of one body: its segments in chronological order, starting with the one being shown.
class MotionTrack {
public:
	/// Maximum number of segments. If more arrive, the oldest is dropped. A segment has at least one tick: so many ticks are known
	/// in any case.
	static constexpr size_t MAX_SEGMENTS = size_t(64) * MAX_TICKS;
	/// Minimum and maximum of the number of segments for which memory is allocated.
	static constexpr size_t MIN_CAPACITY = 2;
	static constexpr size_t MAX_CAPACITY = 2 * MAX_SEGMENTS;

	/// Appends a motion and discards known motion that begins at the same time or later. Instead of allocating memory for more than
	/// `max_capacity` segments, which is at least MIN_CAPACITY, it drops the older half of the segments.
	void add(const BodyMotion &motion, size_t max_capacity = MAX_CAPACITY);
	/// Drops the segments before the one shown at `tick`, and memory if most of it is unused.
	void forget_before(double tick);
	/// Drops all segments. life() remains: the body continues on another time line.
	void restart();
	/// The motion shown at `tick`; null if the body does not exist then.
	[[nodiscard]] const BodyMotion *motion_at(double tick) const;
	/// The first motion that is shown at `tick` or later and belongs to life `min_life` or a later one; null if there is none.
	[[nodiscard]] const BodyMotion *first_motion(double tick, uint64_t min_life) const;
	/// The pose at `tick`. Returns std::nullopt if the body does not exist then.
	[[nodiscard]] std::optional<cga::Pose<double>> pose_at(double tick) const {
		const BodyMotion *motion = motion_at(tick);
		return motion != nullptr ? std::optional(motion->segment.pose_at(tick)) : std::nullopt;
	}
	/// The life of the newest motion; 0 if the body does not exist after it.
	[[nodiscard]] uint64_t life() const { return _life; }
	/// True if the body exists neither at `tick` nor later.
	[[nodiscard]] bool is_over(double tick) const { return is_empty() || (_motions.back().vanishes && _motions.back().segment.begin <= tick); }
	[[nodiscard]] bool is_empty() const { return _motions.size() == _first; }
	/// True if time alone does not change what forget_before() keeps: the body rests, or follows its last motion.
	[[nodiscard]] bool is_settled() const { return _motions.size() == _first + 1 && !_motions.back().vanishes; }
	/// Number of segments for which memory is allocated.
	[[nodiscard]] size_t capacity() const { return _motions.capacity(); }

private:
	void drop_forgotten();

	/// The index after that of the motion shown at `tick`; _first if all known motion is later.
	[[nodiscard]] size_t end_at(double tick) const;

	std::vector<BodyMotion> _motions; // entries before _first are dropped
	size_t _first = 0;
	uint64_t _life = 0;
};

} // namespace net
