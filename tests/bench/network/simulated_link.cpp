#include "simulated_link.hpp"

#include <algorithm>

namespace bench {

void SimulatedLink::send(double now, const uint8_t *bytes, size_t size) {
	const DatagramFate fate = _model.fate(now, size);
	for (int copy = 0; copy < fate.copies; ++copy) {
		_under_way.push_back({ fate.arrivals[size_t(copy)], _number++, Bytes(bytes, bytes + size) });
		std::push_heap(_under_way.begin(), _under_way.end());
	}
}

bool SimulatedLink::receive(double now, Bytes &bytes) {
	if (_under_way.empty() || _under_way.front().arrival > now) {
		return false;
	}
	std::pop_heap(_under_way.begin(), _under_way.end());
	bytes = std::move(_under_way.back().bytes);
	_under_way.pop_back();
	return true;
}

} // namespace bench
