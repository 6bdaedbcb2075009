#pragma once

#include "cga/motor/pose.hpp"
#include "net/delivery/recent_extreme.hpp"

#include <array>
#include <cstddef>

namespace net {

/// The time of frames on the time line of ticks. A script that moves a body in each frame advances it by the frame's
/// duration, so poses of such a body belong to the times that the durations add up to. Times in seconds.
class FrameClock {
public:
	/// A frame of `duration` begins. `fraction` is the part of a tick that has passed since the last tick.
	void frame(double duration, double fraction);
	void tick(double length);
	/// Sets the lag to what the latest frames need. Call it while no body moves in frames, as it would jump.
	void settle() { _lag = _max_duration.is_empty() ? 0.0 : _max_duration.value(); }

	/// The time of the last frame.
	[[nodiscard]] double frame_time() const { return _frames + _offset; }
	[[nodiscard]] double tick_time() const { return _ticks; }
	/// How far poses have to lag behind ticks so that each tick lies between two frames.
	[[nodiscard]] double lag() const { return _lag; }

private:
	double _frames = 0.0; // sum of durations
	double _ticks = 0.0;
	double _tick_length = 0.0;
	double _offset = 0.0; // from _frames to the time line of ticks
	double _lag = 0.0;
	RecentExtreme _max_duration{ 1.0, 1.0 };
	bool _has_frame = false;
};

/// Poses of a body that a script moves in frames, resampled at ticks: the latest frames, interpolated.
class FrameSampler {
public:
	void add(double time, const cga::Pose<double> &pose);
	/// Records that the body is still at its last pose.
	void extend(double time) { add(time, at(time)); }
	/// The pose at `time`: between two frames interpolated, otherwise the nearest. `add` must have been called.
	[[nodiscard]] cga::Pose<double> at(double time) const;
	[[nodiscard]] bool is_empty() const { return _count == 0; }
	/// True if the body has been at one pose since before `time`.
	[[nodiscard]] bool rests_at(double time) const;
	void clear() { _count = 0; }

private:
	struct Sample {
		double time = 0.0;
		cga::Pose<double> pose;
	};
	static constexpr size_t CAPACITY = 8;

	std::array<Sample, CAPACITY> _samples; // in chronological order
	size_t _count = 0;
};

} // namespace net
