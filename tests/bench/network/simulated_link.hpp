#pragma once

#include "link_model.hpp"

#include <vector>

namespace bench {

/// Carries datagrams in one direction as a LinkModel decides.
class SimulatedLink {
public:
	using Bytes = std::vector<uint8_t>;

	SimulatedLink(const LinkSettings &settings, uint64_t seed) :
			_model(settings, seed) {}

	/// Sends `size` bytes `now`, in seconds; calls are in order of time.
	void send(double now, const uint8_t *bytes, size_t size);
	/// Takes the datagram that arrived first, no later than `now`. False if there is none.
	bool receive(double now, Bytes &bytes);

	[[nodiscard]] const LinkModel &model() const { return _model; }

private:
	struct Datagram {
		double arrival = 0.0;
		uint64_t number = 0; // of those that arrive at once, the one sent first comes first
		Bytes bytes;

		// For a heap with the first arrival on top.
		bool operator<(const Datagram &other) const {
			return arrival != other.arrival ? arrival > other.arrival : number > other.number;
		}
	};

	LinkModel _model;
	std::vector<Datagram> _under_way; // a heap
	uint64_t _number = 0;
};

} // namespace bench
