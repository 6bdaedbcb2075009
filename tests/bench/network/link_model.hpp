#pragma once

#include "random_bits.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace bench {

/// One direction of a network path that carries datagrams.
struct LinkSettings {
	double delay = 0.0; ///< seconds that every datagram takes
	double jitter = 0.0; ///< seconds that a datagram takes longer, uniform from 0; they overtake each other
	double loss = 0.0; ///< share that is lost, 0 to 1
	double burst = 0.0; ///< mean number lost in a row; 0: each by itself
	double duplication = 0.0; ///< share that arrives twice, 0 to 1
	double bytes_per_second = 0.0; ///< datagrams wait for each other on a line this fast; 0: no limit
	double longest_queue = 0.5; ///< seconds on the line after which further datagrams are dropped
};

/// When the copies of a datagram arrive.
struct DatagramFate {
	int copies = 0; ///< 0: lost
	std::array<double, 2> arrivals{}; ///< of each copy, in seconds
};

/// Decides over datagrams, one after the other, from a seed.
///
/// Loss in bursts is Gilbert's model: a good state that loses nothing, a bad one that loses all. With the mean loss p
/// and the mean burst length B, the bad state ends with probability 1/B and begins with p / (B (1 - p)).
class LinkModel {
public:
	LinkModel(const LinkSettings &settings, uint64_t seed);

	/// The fate of a datagram of `size` bytes that is sent `now`; calls are in order of time.
	DatagramFate fate(double now, size_t size);

	[[nodiscard]] uint64_t sent_count() const { return _sent; }
	[[nodiscard]] uint64_t lost_count() const { return _lost; }

private:
	bool is_lost();

	LinkSettings _settings;
	RandomBits _random;
	bool _bad = false;
	double _line_free = 0.0; // when the line has sent what waits
	uint64_t _sent = 0;
	uint64_t _lost = 0;
};

} // namespace bench
