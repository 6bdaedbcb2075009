#include "simulated_link.hpp"

#include <algorithm>

namespace harness {

void SimulatedLink::send(double now, const uint8_t *bytes, size_t size) {
	const DatagramFate fate = _model.fate(now, size);
	for (int copy = 0; copy < fate.copies; ++copy) {
		_in_transit.push_back({ { fate.arrivals[size_t(copy)], { bytes, bytes + size } }, _next_number++ });
		std::push_heap(_in_transit.begin(), _in_transit.end());
	}
}

std::optional<Delivery> SimulatedLink::receive(double now) {
	if (next_arrival() > now) {
		return std::nullopt;
	}
	std::pop_heap(_in_transit.begin(), _in_transit.end());
	std::optional<Delivery> delivery = std::move(_in_transit.back().delivery);
	_in_transit.pop_back();
	return delivery;
}

double SimulatedLink::next_arrival() const {
	return _in_transit.empty() ? std::numeric_limits<double>::infinity() : _in_transit.front().delivery.arrival;
}

} // namespace harness
