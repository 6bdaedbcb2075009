#include "net/session/frame_sampler.hpp"

#include "net/motion/motion_sample.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

/// Weight of one second of frames in the mean offset between frames and ticks, and the difference above which the offset is set anew.
constexpr double OFFSET_RATE = 2.0;
constexpr double MAX_OFFSET_ERROR = 0.1;
/// Change of the lag per second: it grows at once, and shrinks slowly, so that the speed of bodies hardly changes.
constexpr double LAG_DECAY = 0.01;
/// A longer frame is a pause, for which the lag does not grow.
constexpr double MAX_DURATION = 0.11;

bool is_same(const cga::Pose<double> &a, const cga::Pose<double> &b) {
	return a.translation == b.translation && a.rotation == b.rotation && a.scale == b.scale;
}

} // namespace

void FrameClock::frame(double duration, double fraction) {
	_frames += duration;
	const double offset = _ticks + fraction * _tick_length - _frames;
	if (!_has_frame || std::fabs(offset - _offset) > MAX_OFFSET_ERROR) {
		_offset = offset;
	}
	_has_frame = true;
	_offset += (offset - _offset) * std::min(OFFSET_RATE * duration, 1.0);
	_max_duration.add(std::min(duration, MAX_DURATION), _frames);
	_lag = std::max(_max_duration.value(), _lag - LAG_DECAY * duration);
}

void FrameClock::tick(double length) {
	_ticks += length;
	_tick_length = length;
}

void FrameSampler::add(double time, const cga::Pose<double> &pose) {
	if (_count > 0 && time <= _samples[_count - 1].time) {
		_samples[_count - 1].pose = pose;
		return;
	}
	if (_count == CAPACITY) {
		std::move(_samples.begin() + 1, _samples.end(), _samples.begin());
		--_count;
	}
	_samples[_count++] = { time, pose };
}

cga::Pose<double> FrameSampler::at(double time) const {
	size_t next = 0;
	while (next < _count && _samples[next].time <= time) {
		++next;
	}
	if (next == 0 || next == _count) {
		return _samples[next == 0 ? 0 : _count - 1].pose;
	}
	const Sample &before = _samples[next - 1];
	const Sample &after = _samples[next];
	return blended(before.pose, after.pose, (time - before.time) / (after.time - before.time));
}

bool FrameSampler::rests_at(double time) const {
	return std::all_of(_samples.begin(), _samples.begin() + ptrdiff_t(_count), [&](const Sample &sample) {
		return sample.time < time || is_same(sample.pose, _samples[_count - 1].pose);
	}) && is_same(at(time), _samples[_count - 1].pose);
}

} // namespace net
