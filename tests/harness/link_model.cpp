#include "link_model.hpp"

#include <algorithm>

namespace harness {

LinkModel::LinkModel(const LinkSettings &settings, uint64_t seed) :
		_settings(settings), _random(seed) {}

bool LinkModel::draw_loss() {
	// Independent losses have bursts of mean length 1 / (1 - loss); Gilbert's model cannot make shorter ones.
	if (_settings.burst * (1.0 - _settings.loss) <= 1.0) {
		return _random.chance(_settings.loss);
	}
	const double begin_probability = _settings.loss / (_settings.burst * (1.0 - _settings.loss));
	_in_burst = _in_burst ? !_random.chance(1.0 / _settings.burst) : _random.chance(begin_probability);
	return _in_burst;
}

DatagramFate LinkModel::fate(double now, size_t size) {
	DatagramFate fate;
	++_sent;
	bool is_lost = now >= _settings.outage_begin && now < _settings.outage_end;
	double departure = now;
	if (!is_lost && _settings.bytes_per_second > 0.0) {
		departure = std::max(now, _line_free_at) + double(size) / _settings.bytes_per_second;
		is_lost = departure - now > _settings.max_queue;
		_line_free_at = is_lost ? _line_free_at : departure;
	}
	if (is_lost || draw_loss()) {
		++_lost;
		_last_loss = now;
		return fate;
	}
	fate.copies = _random.chance(_settings.duplication) ? 2 : 1;
	for (int copy = 0; copy < fate.copies; ++copy) {
		fate.arrivals[size_t(copy)] = departure + _settings.delay + _random.between(0.0, _settings.jitter);
	}
	return fate;
}

} // namespace harness
