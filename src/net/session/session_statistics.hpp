#pragma once

#include <algorithm>
#include <cstdint>

namespace net {

/// Traffic statistics for one peer or for all peers.
struct SessionStatistics {
	double sent_bytes = 0.0; ///< per second
	double sent_packets = 0.0; ///< per second
	double received_bytes = 0.0; ///< per second
	double received_packets = 0.0; ///< per second
	double loss = 0.0; ///< fraction
	double round_trip = 0.0; ///< seconds
	double playback_delay = 0.0; ///< seconds
	double line_rate = 0.0; ///< bytes per second that the peer's line carries; 0 if it carries all that is sent
	double relaxation = 1.0; ///< factor by which errors at the peer may exceed the tolerances, because its line does not carry more
	uint64_t late = 0; ///< windows that arrived after playback had reached their begin
	uint64_t rejected = 0; ///< packets
	uint64_t unauthorized = 0; ///< bodies that a peer sent without being their authority

	/// Adds the statistics of another peer. Of loss, round trip, playback delay and relaxation, the total is the maximum; of the line rate the
	/// minimum.
	void add(const SessionStatistics &other) {
		sent_bytes += other.sent_bytes;
		sent_packets += other.sent_packets;
		received_bytes += other.received_bytes;
		received_packets += other.received_packets;
		loss = std::max(loss, other.loss);
		round_trip = std::max(round_trip, other.round_trip);
		playback_delay = std::max(playback_delay, other.playback_delay);
		line_rate = line_rate == 0.0 || other.line_rate == 0.0 ? std::max(line_rate, other.line_rate) : std::min(line_rate, other.line_rate);
		relaxation = std::max(relaxation, other.relaxation);
		late += other.late;
		rejected += other.rejected;
		unauthorized += other.unauthorized;
	}
};

} // namespace net
