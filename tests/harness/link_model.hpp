#pragma once

#include "random_bits.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace harness {

/// One direction of a network path that carries datagrams. Times are in seconds of the caller's virtual clock.
struct LinkSettings {
	double delay = 0.0; ///< minimum time in transit
	double jitter = 0.0; ///< maximum of the additional, uniformly distributed time in transit; it reorders datagrams
	double loss = 0.0; ///< probability that a datagram is lost, 0 to 1
	double duplication = 0.0; ///< probability that a datagram arrives twice, 0 to 1
	double outage_begin = 0.0; ///< datagrams sent from here up to, not including, outage_end are lost
	double outage_end = 0.0;
	double burst = 0.0; ///< mean length of a loss burst, in datagrams; 0: losses are independent
	double bytes_per_second = 0.0; ///< bandwidth, datagrams queue for it; 0: unlimited
	double max_queue = 0.5; ///< datagrams that would wait and transmit for longer than this are dropped
};

/// When the copies of a datagram arrive.
struct DatagramFate {
	int copies = 0; ///< 0: lost
	std::array<double, 2> arrivals{}; ///< of each copy, in seconds
};

/// Decides which datagrams get lost, duplicated and delayed. The same seed and calls give the same fates.
///
/// Bursts of losses follow Gilbert's model: a good state that loses nothing and a bad one that loses everything. For the
/// mean loss p and the mean burst length B, the bad state ends with probability 1/B and begins with p / (B (1 - p)).
class LinkModel {
public:
	LinkModel(const LinkSettings &settings, uint64_t seed);

	/// The fate of a datagram of `size` bytes sent at `now`, which must not decrease from call to call.
	DatagramFate fate(double now, size_t size);

	/// May be changed at any time; applies to datagrams sent afterwards.
	[[nodiscard]] LinkSettings &settings() { return _settings; }

	[[nodiscard]] uint64_t sent_count() const { return _sent; }
	[[nodiscard]] uint64_t lost_count() const { return _lost; }
	/// When the last lost datagram was sent; -infinity before the first.
	[[nodiscard]] double last_loss_time() const { return _last_loss; }

private:
	bool draw_loss();

	LinkSettings _settings;
	RandomBits _random;
	bool _in_burst = false;
	double _line_free_at = 0.0; // when the queue will be empty
	uint64_t _sent = 0;
	uint64_t _lost = 0;
	double _last_loss = -std::numeric_limits<double>::infinity();
};

} // namespace harness
