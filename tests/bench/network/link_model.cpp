#include "link_model.hpp"

#include <algorithm>

namespace bench {

LinkModel::LinkModel(const LinkSettings &settings, std::uint64_t seed) :
		settings_(settings), random_(seed) {}

bool LinkModel::is_lost() {
	// Bursts that are shorter than chance makes them do not exist; so short ones count as chance.
	if (settings_.burst * (1.0 - settings_.loss) <= 1.0) {
		return random_.chance(settings_.loss);
	}
	const double begins = settings_.loss / (settings_.burst * (1.0 - settings_.loss));
	bad_ = bad_ ? !random_.chance(1.0 / settings_.burst) : random_.chance(begins);
	return bad_;
}

DatagramFate LinkModel::fate(double now, std::size_t size) {
	DatagramFate fate;
	++sent_;
	double departure = now;
	if (settings_.bytes_per_second > 0.0) {
		departure = std::max(now, line_free_) + double(size) / settings_.bytes_per_second;
		if (departure - now > settings_.longest_queue) {
			++lost_;
			return fate;
		}
		line_free_ = departure;
	}
	if (is_lost()) {
		++lost_;
		return fate;
	}
	fate.copies = random_.chance(settings_.duplication) ? 2 : 1;
	for (int copy = 0; copy < fate.copies; ++copy) {
		fate.arrivals[std::size_t(copy)] = departure + settings_.delay + random_.between(0.0, settings_.jitter);
	}
	return fate;
}

} // namespace bench
