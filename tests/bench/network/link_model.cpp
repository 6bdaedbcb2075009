#include "link_model.hpp"

#include <algorithm>

namespace bench {

LinkModel::LinkModel(const LinkSettings &settings, uint64_t seed) :
		_settings(settings), _random(seed) {}

bool LinkModel::is_lost() {
	// Bursts that are shorter than chance makes them do not exist; so short ones count as chance.
	if (_settings.burst * (1.0 - _settings.loss) <= 1.0) {
		return _random.chance(_settings.loss);
	}
	const double begins = _settings.loss / (_settings.burst * (1.0 - _settings.loss));
	_bad = _bad ? !_random.chance(1.0 / _settings.burst) : _random.chance(begins);
	return _bad;
}

DatagramFate LinkModel::fate(double now, size_t size) {
	DatagramFate fate;
	++_sent;
	double departure = now;
	if (_settings.bytes_per_second > 0.0) {
		departure = std::max(now, _line_free) + double(size) / _settings.bytes_per_second;
		if (departure - now > _settings.longest_queue) {
			++_lost;
			return fate;
		}
		_line_free = departure;
	}
	if (is_lost()) {
		++_lost;
		return fate;
	}
	fate.copies = _random.chance(_settings.duplication) ? 2 : 1;
	for (int copy = 0; copy < fate.copies; ++copy) {
		fate.arrivals[size_t(copy)] = departure + _settings.delay + _random.between(0.0, _settings.jitter);
	}
	return fate;
}

} // namespace bench
