#include "net/delivery/arrival_line.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

/// Gains of the filter for arrivals at least FULL_STEP seconds apart. Closer ones count less.
constexpr double ALPHA = 0.2;
constexpr double BETA = 0.022;
constexpr double FULL_STEP = 0.1;
/// An arrival is far from the line beyond this many mean distances, within these limits in seconds.
constexpr double FAR_SPREADS = 5.0;
constexpr double MIN_FAR = 0.04;
constexpr double MAX_FAR = 0.3;
constexpr double SPREAD_WEIGHT = 1.0 / 16.0;
/// If arrivals are consistently on one side of the line, the gains are raised by the ratio of their mean distance to their spread.
constexpr double BIAS_WEIGHT = 1.0 / 4.0;
constexpr double NO_SPREAD = 0.002;
constexpr double MAX_BOOST = 4.0;
/// Retransmissions may be this late, in seconds.
constexpr double LOSS_LATENESS = 1.0;
/// Limits of the drift: senders from a quarter of real time to twice.
constexpr double MIN_DRIFT = -1.0;
constexpr double MAX_DRIFT = 0.75;
/// A drift is noise up to this value, and up to this many times the spread.
constexpr double MIN_NOTABLE_DRIFT = 0.01;
constexpr double DRIFT_PER_SPREAD = 2.5;
/// If the line moves twice within this many seconds, a smaller difference is enough to conclude that the sender is slow.
constexpr double SAME_CAUSE = 2.0;
/// Arrivals farther apart than this, in seconds, say nothing about the slope.
constexpr double MAX_STEP = 1.0;

} // namespace

void ArrivalLine::start(double end, double now) {
	*this = ArrivalLine();
	move_to(end, now);
}

void ArrivalLine::move_to(double end, double now) {
	_offset = now - end;
	_time = now;
	_is_late = false;
	_mean_drift = _drift;
	for (RecentExtreme *extreme : { &_earliest, &_latest, &_earliest_offset, &_latest_offset }) {
		extreme->clear();
	}
	_earliest.add(0.0, now);
	_latest.add(0.0, now);
	_earliest_offset.add(_offset, now);
	_latest_offset.add(_offset, now);
}

bool ArrivalLine::is_drifting() const {
	return std::fabs(_mean_drift) > std::max(MIN_NOTABLE_DRIFT, DRIFT_PER_SPREAD * _spread);
}

double ArrivalLine::newest_at(double now) const {
	// Without drift, the offset of the earliest arrival is more accurate than its distance from the line.
	return now - (is_drifting() ? _offset + _drift * (now - _time) + _earliest.value() : _earliest_offset.value());
}

ArrivalLine::Arrival ArrivalLine::add(double end, double now, bool has_losses) {
	const double step = std::max(now - _time, 0.0);
	const double predicted = _offset + _drift * step;
	const double distance = now - end - predicted;
	const double bound = std::clamp(FAR_SPREADS * _spread, MIN_FAR, MAX_FAR);
	const double late_bound = bound + (has_losses ? LOSS_LATENESS : 0.0);
	if (distance > late_bound) {
		return add_late(end, now, late_bound);
	}
	if (distance < -bound) {
		_drift = _is_early && step > 0.0 && step < MAX_STEP ? std::clamp(_drift + distance / step, MIN_DRIFT, MAX_DRIFT) : _drift;
		_is_early = true;
		move_to(end, now);
		return Arrival::EXPECTED;
	}
	const double share = std::min(step / FULL_STEP, 1.0);
	const double near = std::min(distance, bound);
	_bias += (near - _bias) * BIAS_WEIGHT;
	_spread += (std::fabs(near - _bias) - _spread) * SPREAD_WEIGHT;
	const double boost = std::clamp(std::fabs(_bias) / (_spread + NO_SPREAD), 1.0, MAX_BOOST);
	_offset = predicted + ALPHA * boost * share * near;
	_drift = std::clamp(_drift + BETA * boost * boost * share * near / std::max(step, FULL_STEP), MIN_DRIFT, MAX_DRIFT);
	_mean_drift += (_drift - _mean_drift) * BIAS_WEIGHT;
	_time = now;
	_earliest.add(distance, now);
	_latest.add(distance, now);
	if (is_drifting()) {
		_earliest_offset.clear();
		_latest_offset.clear();
	}
	_earliest_offset.add(now - end, now);
	_latest_offset.add(now - end, now);
	_is_late = _is_early = false;
	return Arrival::EXPECTED;
}

ArrivalLine::Arrival ArrivalLine::add_late(double end, double now, double bound) {
	const double step = now - _late_time;
	const double later = now - end - (_late_offset + _drift * step);
	const bool was_late = _is_late;
	_is_early = false;
	_is_late = true;
	_late_offset = now - end;
	_late_time = now;
	if (!was_late || later < -bound) {
		return Arrival::SUSPECT;
	}
	if (step > MAX_STEP) {
		_drift = 0.0;
	} else if (later > 0.5 * bound && now - _moved_at < SAME_CAUSE) {
		_drift = std::clamp((now - end - _moved_offset) / (now - _moved_at), MIN_DRIFT, MAX_DRIFT);
	} else if (later > bound) {
		_drift = std::clamp(_drift + later / step, MIN_DRIFT, MAX_DRIFT);
	}
	_moved_at = now;
	_moved_offset = now - end;
	move_to(end, now);
	return Arrival::MOVED;
}

} // namespace net
