#pragma once

#include "link_model.hpp"

#include <optional>
#include <vector>

namespace harness {

/// A datagram at the receiving end of a link.
struct Delivery {
	double arrival = 0.0; ///< seconds
	std::vector<uint8_t> bytes;
};

/// One direction of a network in virtual time: carries datagrams of any content as a LinkModel decides.
class SimulatedLink {
public:
	SimulatedLink(const LinkSettings &settings, uint64_t seed) :
			_model(settings, seed) {}

	/// Sends `size` bytes at `now`, in seconds, which must not decrease from call to call.
	void send(double now, const uint8_t *bytes, size_t size);
	/// Takes the datagram that arrives first, if it arrives no later than `now`. Datagrams that arrive at the same time
	/// are delivered in the order in which they were sent.
	[[nodiscard]] std::optional<Delivery> receive(double now);
	/// When the next datagram arrives; +infinity if none is in transit.
	[[nodiscard]] double next_arrival() const;

	[[nodiscard]] LinkSettings &settings() { return _model.settings(); }
	[[nodiscard]] const LinkModel &model() const { return _model; }

private:
	struct Datagram {
		Delivery delivery;
		uint64_t number = 0; // in the order of sending

		// For a heap with the first arrival on top.
		bool operator<(const Datagram &other) const {
			return delivery.arrival != other.delivery.arrival ? delivery.arrival > other.delivery.arrival : number > other.number;
		}
	};

	LinkModel _model;
	std::vector<Datagram> _in_transit; // a heap
	uint64_t _next_number = 0;
};

} // namespace harness
