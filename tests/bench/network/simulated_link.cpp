#include "simulated_link.hpp"

#include <algorithm>

namespace bench {

void SimulatedLink::send(double now, const std::uint8_t *bytes, std::size_t size) {
	const DatagramFate fate = model_.fate(now, size);
	for (int copy = 0; copy < fate.copies; ++copy) {
		under_way_.push_back({ fate.arrivals[std::size_t(copy)], number_++, Bytes(bytes, bytes + size) });
		std::push_heap(under_way_.begin(), under_way_.end());
	}
}

bool SimulatedLink::receive(double now, Bytes &bytes) {
	if (under_way_.empty() || under_way_.front().arrival > now) {
		return false;
	}
	std::pop_heap(under_way_.begin(), under_way_.end());
	bytes = std::move(under_way_.back().bytes);
	under_way_.pop_back();
	return true;
}

} // namespace bench
