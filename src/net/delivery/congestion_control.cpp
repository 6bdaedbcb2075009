#include "net/delivery/congestion_control.hpp"

#include <algorithm>

namespace net {

size_t CongestionControl::allowance(double time) {
	const double step = std::clamp(time - _tokens_at, 0.0, MAX_EPOCH);
	_tokens_at = time;
	// Whatever the window, one packet may be in flight.
	const double window = _in_flight == 0 ? std::max(_window, PACKET) : _window - double(_in_flight);
	if (_is_slow_start) {
		return size_t(std::max(window, 0.0));
	}
	constexpr double PACING = 1.25; // of the rate, so that the window remains the limit
	_tokens = std::min(_tokens + PACING * rate() * step, std::max(_window, PACKET));
	return _tokens > 0.0 ? size_t(std::max(std::min(window, std::max(_tokens, PACKET)), 0.0)) : 0;
}

double CongestionControl::rate() const {
	return _round_trip > 0.0 ? _window / std::max(_round_trip, MIN_EPOCH / 2.0) : INITIAL_WINDOW / MIN_EPOCH;
}

void CongestionControl::acknowledged(size_t bytes, double round_trip, double time) {
	if (!_is_validated) {
		_is_validated = true;
		_epoch = Epoch{ time };
	}
	if (time - _acknowledged_at > OUTAGE) {
		_lost = _arrived = 0.0; // an outage says nothing of the rate
	}
	_acknowledged_at = time;
	_lost_in_row = 0.0;
	_epoch.delivered += bytes;
	++_epoch.acknowledgements;
	_arrived += time - _round_trip >= _cut_at ? double(bytes) : 0.0;
	if (round_trip > 0.0) {
		_base.add(round_trip, time);
		_epoch.min_round_trip = _epoch.samples == 0 ? round_trip : std::min(_epoch.min_round_trip, round_trip);
		++_epoch.samples;
	}
	const double length = time - _epoch.begin;
	if ((length >= std::max(_round_trip, MIN_EPOCH) && _epoch.acknowledgements >= MIN_ACKNOWLEDGEMENTS) || length > MAX_EPOCH) {
		finish_epoch(time);
	}
}

void CongestionControl::finish_epoch(double time) {
	// Repeated packets give no round-trip samples, but tell what is delivered and lost.
	_round_trip = _epoch.samples > 0 ? _epoch.min_round_trip : _round_trip;
	const double length = std::max(time - _epoch.begin, 1e-6);
	const double rate_now = double(_epoch.delivered) / length;
	_smooth_delivered += (rate_now - _smooth_delivered) * (_delivered.is_empty() ? 1.0 : std::min(length / SMOOTH_SPAN, 1.0));
	_delivered.add(rate_now, time);
	const double delivered = _delivered.value();
	const double base = _base.is_empty() ? _round_trip : _base.value();
	const double max_queue = std::max({ MAX_QUEUE, MAX_QUEUE_SHARE * base, MAX_QUEUE_PACKETS * PACKET / std::max(delivered, PACKET) });
	const bool is_queue_long = _epoch.samples > 0 && _round_trip - base > max_queue;
	if (is_queue_long && is_longer_route()) {
		_base.clear();
		_base.add(_round_trip, time);
		_cuts = 0;
	} else if (is_queue_long) {
		_cut_round_trip = _cuts == 0 ? _round_trip : _cut_round_trip;
		++_cuts;
		reduce(delivered, base + 0.5 * max_queue, time);
	} else if (is_loss_congestion()) {
		reduce(std::max(_smooth_delivered, MIN_DELIVERED_SHARE * delivered), 0.5 * (base + _round_trip), time);
	} else {
		_cuts = _epoch.samples > 0 ? 0 : _cuts;
		if (_is_limited && _cut_loss == 0.0 && recent_loss() <= _background_loss + GROWTH_LOSS_MARGIN) {
			_window = std::min(_window + (_is_slow_start ? _window : std::max(GROWTH * _window, MIN_GROWTH)), MAX_WINDOW);
		}
	}
	_was_limited = _is_limited;
	_is_limited = false;
	_epoch = Epoch{ time };
}

void CongestionControl::lost(size_t bytes, double sent_at) {
	left(bytes);
	if (!_is_validated) {
		return; // The round trip is unknown: it may merely be longer than the timeout.
	}
	_lost += sent_at >= _cut_at ? double(bytes) : 0.0;
	_lost_in_row += double(bytes);
	if (_lost_in_row > _window) {
		// Nothing arrives (persistent congestion, RFC 9002, section 7.6): begin again with little.
		_lost_in_row = 0.0;
		if (_window > MIN_RESTART) {
			_window = std::max(0.5 * _window, MIN_RESTART);
			_is_slow_start = true;
		}
	}
}

bool CongestionControl::is_loss_congestion() {
	const double loss = recent_loss();
	const double span = loss > OBVIOUS_LOSS ? OBVIOUS_LOSS_SPAN : std::min(LOSS_SPAN, 4.0 * std::max(_window, PACKET));
	if (_lost + _arrived < span) {
		return false;
	}
	_lost = _arrived = 0.0;
	if (_cut_loss > 0.0 && loss > REMAINING * _cut_loss && _window > 2.0 * MIN_WINDOW) {
		// Sending less has not helped.
		_background_loss = std::max(_background_loss, loss);
		_window = std::max(_window, _cut_window);
		_cut_loss = 0.0;
		return false;
	}
	_cut_loss = 0.0;
	if (loss <= _background_loss + (_is_limited || _was_limited ? LOSS_MARGIN : UNLIMITED_LOSS_MARGIN)) {
		_background_loss += LOSS_FORGOTTEN * (std::min(loss, _background_loss) - _background_loss);
		return false;
	}
	_cut_loss = loss;
	_cut_window = _window;
	return true;
}

void CongestionControl::reduce(double delivered_rate, double seconds, double time) {
	_cut_at = time;
	_lost = _arrived = 0.0;
	if (_is_slow_start) {
		_is_slow_start = false;
		_tokens = 0.0;
	}
	_window = std::clamp(delivered_rate * seconds, MIN_WINDOW, std::max(_window, MIN_WINDOW));
}

} // namespace net
