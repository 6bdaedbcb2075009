#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

/// Counts values in bins that are 1 % wide, from 1e-7 to 1e5. Its memory does not depend on the number of values.
class Histogram {
public:
	void add(double value);
	void add(const Histogram &other);
	[[nodiscard]] uint64_t count() const { return _count; }
	/// The value at `share` (0 to 1), to 1 %; NaN without values.
	[[nodiscard]] double percentile(double share) const;
	[[nodiscard]] double max() const;

private:
	static constexpr size_t BINS = 2800;

	std::array<uint32_t, BINS> _bins{};
	uint64_t _count = 0;
	double _max = 0.0;
};

/// The bytes that a receiver was sent in each tick.
class TickBytes {
public:
	void reserve(size_t ticks) { _ticks.reserve(ticks); }
	void add(size_t bytes) { _ticks.push_back(uint32_t(bytes)); }
	[[nodiscard]] size_t count() const { return _ticks.size(); }
	[[nodiscard]] uint64_t total() const;
	/// The bytes above the mean per tick of the tick at `share` (0 to 1) of all ticks by size; 1: of the largest. 0 without ticks.
	[[nodiscard]] uint32_t max() const { return _ticks.empty() ? 0 : *std::max_element(_ticks.begin(), _ticks.end()); }
	[[nodiscard]] double burst(double share) const;

private:
	std::vector<uint32_t> _ticks;
};

/// How steadily a receiver's playback advances.
class Playback {
public:
	/// `shown`: the media time of the newest motion that a frame at `now` shows, in seconds.
	void add(double now, double shown);
	/// The share of frames in which nothing new was shown, from 0 to 1.
	[[nodiscard]] double frozen_share() const { return _frames > 0 ? double(_frozen) / double(_frames) : 0.0; }
	/// The longest time in which nothing new was shown, in seconds.
	[[nodiscard]] double longest_stall() const { return _longest; }

private:
	uint64_t _frames = 0;
	uint64_t _frozen = 0;
	double _shown = -1e9;
	double _shown_at = 0.0; // when it last advanced
	double _longest = 0.0;
};

/// Processor time and memory of one part of the program: of what runs between begin() and end(), each time.
class Meter {
public:
	void begin();
	void end();
	/// Later calls count as measured: earlier processor time is discarded.
	void reset_time() { _seconds = 0.0; }
	[[nodiscard]] double seconds() const { return _seconds; }
	/// Allocated bytes in use.
	[[nodiscard]] double live() const { return double(_live); }
	/// Takes the largest live() since the last call.
	[[nodiscard]] double take_peak();

private:
	double _seconds = 0.0;
	double _begin = 0.0;
	int64_t _live = 0;
	int64_t _peak = 0;
	int64_t _live_begin = 0;
};

} // namespace bench
