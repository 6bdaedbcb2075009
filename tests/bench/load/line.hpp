#pragma once

#include "../../harness/simulated_link.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace bench {

/// From `time` on, in seconds, the line carries `bytes_per_second`; 0: unlimited.
struct LineRate {
	double time = 0.0;
	double bytes_per_second = 0.0;
};

/// One direction of the line to a receiver: a bottleneck, then a path with delay and random loss. Rates count the bytes of datagrams
/// without UDP and IP headers.
struct LineSettings {
	harness::LinkSettings path; ///< delay, jitter, loss and bursts of loss; its own bandwidth stays 0
	std::vector<LineRate> rates; ///< of the bottleneck, by ascending time; empty: unlimited
	double queue = 0.2; ///< seconds of the current rate that the queue holds; it drops what does not fit
	bool polices = false; ///< no queue: what exceeds the rate for longer than `queue` is dropped at once
};

class Line {
public:
	Line(const LineSettings &settings, uint64_t seed) :
			_settings(settings), _path(settings.path, seed) {}

	/// Sends a datagram at `now`, in seconds, which must not decrease over all calls.
	void send(double now, const uint8_t *bytes, size_t size);
	/// Takes the datagram that arrives first, if it arrives no later than `now`.
	[[nodiscard]] std::optional<harness::Delivery> receive(double now);

	/// Datagrams that the bottleneck dropped.
	[[nodiscard]] uint64_t dropped() const { return _dropped; }

private:
	struct Queued {
		std::vector<uint8_t> bytes;
		double remaining = 0.0; // bytes not transmitted yet
	};

	[[nodiscard]] double rate() const;
	/// When the rate changes after the clock; +infinity if it does not.
	[[nodiscard]] double next_change() const;
	/// Transmits up to `now`.
	void advance(double now);
	[[nodiscard]] bool has_room(double now, size_t size);

	LineSettings _settings;
	harness::SimulatedLink _path;
	std::deque<Queued> _queue;
	double _clock = 0.0; // up to which the bottleneck has transmitted
	double _backlog = 0.0; // bytes in the queue
	double _tokens = 0.0; // bytes that a policer would pass now
	double _tokens_at = -1.0;
	uint64_t _dropped = 0;
};

} // namespace bench
