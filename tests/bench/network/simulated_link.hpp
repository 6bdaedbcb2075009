#pragma once

#include "link_model.hpp"

#include <vector>

namespace bench {

/// Carries datagrams in one direction as a LinkModel decides.
class SimulatedLink {
public:
	using Bytes = std::vector<std::uint8_t>;

	SimulatedLink(const LinkSettings &settings, std::uint64_t seed) :
			model_(settings, seed) {}

	/// Sends `size` bytes `now`, in seconds; calls are in order of time.
	void send(double now, const std::uint8_t *bytes, std::size_t size);
	/// Takes the datagram that arrived first, no later than `now`. False if there is none.
	bool receive(double now, Bytes &bytes);

	[[nodiscard]] const LinkModel &model() const { return model_; }

private:
	struct Datagram {
		double arrival = 0.0;
		std::uint64_t number = 0; // of those that arrive at once, the one sent first comes first
		Bytes bytes;

		// For a heap with the first arrival on top.
		bool operator<(const Datagram &other) const {
			return arrival != other.arrival ? arrival > other.arrival : number > other.number;
		}
	};

	LinkModel model_;
	std::vector<Datagram> under_way_; // a heap
	std::uint64_t number_ = 0;
};

} // namespace bench
