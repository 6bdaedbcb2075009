#include "line.hpp"

#include <algorithm>
#include <limits>

namespace bench {

namespace {

constexpr double MIN_QUEUE = 3000.0; // bytes; room for a few datagrams at any rate

} // namespace

double Line::rate() const {
	double rate = 0.0;
	for (const LineRate &change : _settings.rates) {
		rate = change.time <= _clock ? change.bytes_per_second : rate;
	}
	return rate;
}

double Line::next_change() const {
	for (const LineRate &change : _settings.rates) {
		if (change.time > _clock) {
			return change.time;
		}
	}
	return std::numeric_limits<double>::infinity();
}

void Line::advance(double now) {
	while (!_queue.empty() && _clock < now) {
		Queued &first = _queue.front();
		const double current = rate();
		const double until = std::min(now, next_change());
		const double done = current > 0.0 ? _clock + first.remaining / current : _clock;
		if (done > until) {
			first.remaining -= (until - _clock) * current;
			_backlog -= (until - _clock) * current;
			_clock = until;
			continue;
		}
		_clock = done;
		_backlog -= first.remaining;
		_path.send(_clock, first.bytes.data(), first.bytes.size());
		_queue.pop_front();
	}
	if (_queue.empty()) {
		_clock = std::max(_clock, now);
		_backlog = 0.0;
	}
}

bool Line::has_room(double now, size_t size) {
	const double current = rate();
	const double room = std::max(current * _settings.queue, MIN_QUEUE);
	if (!_settings.polices) {
		return _backlog + double(size) <= room;
	}
	_tokens = _tokens_at < 0.0 ? room : std::min(room, _tokens + (now - _tokens_at) * current);
	_tokens_at = now;
	if (_tokens < double(size)) {
		return false;
	}
	_tokens -= double(size);
	return true;
}

void Line::send(double now, const uint8_t *bytes, size_t size) {
	advance(now);
	const double current = rate();
	if (current > 0.0 && !has_room(now, size)) {
		++_dropped;
	} else if (_queue.empty() && (current == 0.0 || _settings.polices)) {
		_path.send(now, bytes, size);
	} else {
		_queue.push_back({ { bytes, bytes + size }, double(size) });
		_backlog += double(size);
	}
}

std::optional<harness::Delivery> Line::receive(double now) {
	advance(now);
	return _path.receive(now);
}

} // namespace bench
