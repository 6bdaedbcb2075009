#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace net {

/// Measures the loss of packets to a receiver from the number of packets that it reports. Unlike the share of chunks that
/// need a retransmission, it does not depend on how often chunks are sent. Times in seconds.
class LossMeter {
public:
	/// A packet was sent at `time`.
	void sent(double time) { _times[_sent++ % _times.size()] = time; }
	/// The receiver has received `received` packets modulo 256. It sent this report when those sent until `time` had arrived.
	void reported(uint8_t received, double time) {
		const bool is_lagging = _sent - _due > _times.size();
		_due = is_lagging ? uint32_t(_sent - _times.size()) : _due;
		while (_due != _sent && _times[_due % _times.size()] <= time) {
			++_due;
		}
		const uint32_t due = _due - _counted;
		const uint32_t arrived = uint8_t(received - _received);
		// Too many have arrived if the round trip has become shorter, or if the receiver is a new one.
		if (_is_started && due <= MAX_SPAN && (due < SPAN || arrived > 2 * due)) {
			return;
		}
		if (_is_started && due <= MAX_SPAN && !is_lagging) {
			// Negative if the round trip has become shorter, which cancels the excess of when it became longer.
			_loss += (1.0 - double(arrived) / double(due) - _loss) * WEIGHT;
		}
		_is_started = true;
		_counted = _due;
		_received = received;
	}
	/// The recent fraction of packets lost. Jitter can make it wrong by a few percent.
	[[nodiscard]] double loss() const { return std::clamp(_loss, 0.0, 1.0); }

private:
	/// Number of packets in one sample. The count is modulo 256, so that it says nothing about more than MAX_SPAN.
	static constexpr uint32_t SPAN = 24;
	static constexpr uint32_t MAX_SPAN = 200;
	static constexpr double WEIGHT = 0.3; // of one sample

	std::array<double, 256> _times{}; // of the last packets
	uint32_t _sent = 0;
	uint32_t _due = 0; // packets that had arrived, or were lost, at the last report
	uint32_t _counted = 0; // _due at the last sample
	uint8_t _received = 0; // at the last sample
	double _loss = 0.0;
	bool _is_started = false;
};

} // namespace net
