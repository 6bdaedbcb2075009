#include "net/delivery/congestion_control.hpp"

#include <algorithm>

namespace net {

size_t CongestionControl::allowance() const {
	const double window = _window - double(_in_flight);
	const size_t allowed = window > 0.0 ? size_t(window) : 0;
	return _is_validated ? allowed : std::min(allowed, _credit);
}

double CongestionControl::rate() const {
	return _round_trip > 0.0 ? _window / std::max(_round_trip, MIN_EPOCH / 2.0) : INITIAL_WINDOW / MIN_EPOCH;
}

void CongestionControl::acknowledged(size_t bytes, double round_trip, double loss, double time) {
	if (!_is_validated) {
		_is_validated = true;
		_epoch = Epoch{ time };
	}
	_epoch.delivered += bytes;
	if (round_trip > 0.0) {
		_base.add(round_trip, time);
		_epoch.min_round_trip = _epoch.samples == 0 ? round_trip : std::min(_epoch.min_round_trip, round_trip);
		++_epoch.samples;
	}
	const double length = time - _epoch.begin;
	if ((length >= std::max(_round_trip, MIN_EPOCH) && _epoch.samples >= MIN_SAMPLES) || length > MAX_EPOCH) {
		finish_epoch(loss, time);
	}
}

void CongestionControl::finish_epoch(double loss, double time) {
	if (_epoch.samples > 0) {
		_round_trip = _epoch.min_round_trip;
		const double delivered = double(_epoch.delivered) / (time - _epoch.begin);
		const double base = _base.value();
		const double max_queue = std::max(MAX_QUEUE, MAX_QUEUE_SHARE * base);
		_test_epochs -= _test_epochs > 0 ? 1 : 0;
		if (_test_epochs == 1) {
			// The loss meter has had time to forget the loss before the reduction.
			if (loss > 0.6 * _cut_loss) {
				_background_loss = std::max(_background_loss, loss);
				_window = std::max(_window, _cut_window);
			}
			_test_epochs = 0;
		}
		if (_round_trip - base > max_queue && is_longer_route()) {
			_base.clear();
			_base.add(_round_trip, time);
			_cuts = 0;
		} else if (_round_trip - base > max_queue) {
			_cut_round_trip = _cuts == 0 ? _round_trip : _cut_round_trip;
			++_cuts;
			reduce(delivered, base + 0.5 * max_queue);
		} else if (_test_epochs == 0 && loss > _background_loss + LOSS_MARGIN && (_is_limited || _was_limited)) {
			_cut_loss = loss;
			_cut_window = _window;
			_test_epochs = 5;
			reduce(delivered, _round_trip);
		} else {
			_cuts = 0;
			_background_loss = std::max(std::min(_background_loss, loss), _background_loss - 0.002);
			if (_is_limited && _test_epochs == 0) {
				_window = std::min(_window + (_is_slow_start ? _window : std::max(GROWTH * _window, PACKET)), MAX_WINDOW);
			}
		}
	}
	_was_limited = _is_limited;
	_is_limited = false;
	_epoch = Epoch{ time };
}

void CongestionControl::reduce(double delivered_rate, double seconds) {
	_is_slow_start = false;
	_window = std::clamp(delivered_rate * seconds, MIN_WINDOW, _window);
}

} // namespace net
