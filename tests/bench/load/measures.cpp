#include "measures.hpp"

#include "../../harness/allocation_counter.hpp"
#include "../cpu_clock.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace bench {

namespace {

constexpr double MIN_VALUE = 1e-7;
constexpr double BINS_PER_LOG = 100.0; // bins per factor e
/// Media time that counts as progress, in seconds: more than rounding, and less than a frame in slow motion.
constexpr double PROGRESS = 1e-4;

} // namespace

void Histogram::add(double value) {
	const double place = value > MIN_VALUE ? std::log(value / MIN_VALUE) * BINS_PER_LOG : 0.0;
	++_bins[std::isfinite(place) ? std::min(size_t(place), BINS - 1) : BINS - 1];
	++_count;
	_max = std::max(_max, value);
}

void Histogram::add(const Histogram &other) {
	for (size_t i = 0; i < BINS; ++i) {
		_bins[i] += other._bins[i];
	}
	_count += other._count;
	_max = std::max(_max, other._max);
}

double Histogram::percentile(double share) const {
	uint64_t below = 0;
	for (size_t i = 0; i < BINS; ++i) {
		below += _bins[i];
		if (_count > 0 && double(below) >= share * double(_count)) {
			return std::min(MIN_VALUE * std::exp(double(i + 1) / BINS_PER_LOG), _max);
		}
	}
	return std::numeric_limits<double>::quiet_NaN();
}

double Histogram::max() const {
	return _count > 0 ? _max : std::numeric_limits<double>::quiet_NaN();
}

uint64_t TickBytes::total() const {
	return std::accumulate(_ticks.begin(), _ticks.end(), uint64_t(0));
}

double TickBytes::burst(double share) const {
	if (_ticks.empty()) {
		return 0.0;
	}
	std::vector<uint32_t> sorted = _ticks;
	std::sort(sorted.begin(), sorted.end());
	const size_t place = size_t(share * double(sorted.size() - 1));
	return double(sorted[place]) - double(total()) / double(sorted.size());
}

void Playback::add(double now, double shown) {
	const bool has_advanced = shown > _shown + PROGRESS;
	if (_frames == 0 || has_advanced) {
		_shown = shown;
		_longest = _frames == 0 ? 0.0 : std::max(_longest, now - _shown_at);
		_shown_at = now;
	} else {
		++_frozen;
		_longest = std::max(_longest, now - _shown_at);
	}
	++_frames;
}

void Meter::begin() {
	_live_begin = int64_t(harness::live_bytes());
	_begin = cpu_seconds();
}

void Meter::end() {
	_seconds += cpu_seconds() - _begin;
	_live += int64_t(harness::live_bytes()) - _live_begin;
	_peak = std::max(_peak, _live);
}

double Meter::take_peak() {
	const double peak = double(_peak);
	_peak = _live;
	return peak;
}

} // namespace bench
