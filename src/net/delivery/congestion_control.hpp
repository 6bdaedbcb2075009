#pragma once

#include "net/delivery/recent_extreme.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace net {

/// Limits the bytes in flight to one receiver to what its line carries: a congestion window (RFC 9002, section 7).
///
/// It grows while it limits the sender: doubled per round trip at first, later by a fixed part. If the queueing delay (the round trip above
/// its minimum) exceeds a bound, the window falls to what has just been delivered in the minimum round trip, so that the queue drains, as in
/// Copa (Arun and Balakrishnan, 2018). If much is lost, the window falls too. If the loss then remains, the window returns to its value:
/// a line that loses a part of all packets is not congested.
///
/// Times in seconds.
class CongestionControl {
public:
	/// Bytes that may be sent at `time`. A packet may exceed them if they are not 0.
	[[nodiscard]] size_t allowance(double time);
	/// True if more than half of the window is in flight.
	[[nodiscard]] bool is_half_full() const { return 2.0 * double(_in_flight) > _window; }
	/// The sender has more to send than the window allows.
	void set_limited() { _is_limited = true; }

	void sent(size_t bytes) {
		_in_flight += bytes;
		_tokens -= double(bytes);
	}
	/// `bytes` in flight are known to have left the network: acknowledged, or lost.
	void left(size_t bytes) { _in_flight -= std::min(bytes, _in_flight); }
	/// `bytes` in flight, sent at `sent_at`, have probably been lost.
	void lost(size_t bytes, double sent_at);
	/// The receiver has acknowledged `bytes`. `round_trip` is that of the newest acknowledged packet, 0 if it is unknown.
	void acknowledged(size_t bytes, double round_trip, double time);

	/// Bytes per second that the line carries, as far as known: more if the window has not limited the sender lately.
	[[nodiscard]] double rate() const;
	/// Bytes per second that arrive over a line that limits the sender.
	[[nodiscard]] double delivered_rate() const { return std::min(rate(), _smooth_delivered); }
	/// True if the line has shown its limit, and the window has limited the sender in the last two round trips.
	[[nodiscard]] bool is_limiting() const { return !_is_slow_start && (_was_limited || _is_limited); }
	/// The share of bytes lost since the loss was last judged.
	[[nodiscard]] double recent_loss() const { return _lost > 0.0 ? _lost / (_lost + _arrived) : 0.0; }
	/// True if packets wait in a queue of a line that has shown its limit: more bytes would delay all.
	[[nodiscard]] bool has_queue() const { return !_is_slow_start && !_base.is_empty() && _round_trip - _base.value() > NOTABLE_QUEUE; }
	/// True from the first acknowledgement on.
	[[nodiscard]] bool is_validated() const { return _is_validated; }

private:
	struct Epoch {
		double begin = 0.0;
		double min_round_trip = 0.0; // 0: no sample
		int samples = 0; // of the round trip
		int acknowledgements = 0;
		size_t delivered = 0;
	};

	void finish_epoch(double time);
	/// Judges the loss since the last call, if enough has been sent. Returns true if it means congestion.
	bool is_loss_congestion();
	/// Reduces the window, at `time`, to what is delivered in `seconds`.
	void reduce(double delivered_rate, double seconds, double time);
	/// True if the queue remains although less is sent: then it is not ours, or the route has become longer.
	[[nodiscard]] bool is_longer_route() const { return _cuts >= MAX_CUTS && _epoch.min_round_trip > 0.9 * _cut_round_trip; }

	static constexpr double PACKET = 1200.0;
	static constexpr double INITIAL_WINDOW = 24 * PACKET;
	static constexpr double MIN_WINDOW = 300.0; // less than a packet: then packets are sent at a rate
	static constexpr double MIN_RESTART = 8 * PACKET; // after a time in which nothing arrived
	static constexpr double MAX_WINDOW = 16e6;
	/// Growth per round trip after the first reduction.
	static constexpr double GROWTH = 0.08;
	static constexpr double MIN_GROWTH = 0.05 * PACKET;
	/// Maximum queueing delay, in seconds, as a fraction of the round trip, and in packets, which a narrow line takes long to send.
	static constexpr double MAX_QUEUE = 0.05;
	static constexpr double MAX_QUEUE_SHARE = 0.25;
	static constexpr double MAX_QUEUE_PACKETS = 2.5;
	/// Queueing delay, in seconds, from which packets wait in a queue.
	static constexpr double NOTABLE_QUEUE = 0.025;
	/// Reductions in a row after which a queueing delay that remains counts as a longer route.
	static constexpr int MAX_CUTS = 3;
	/// Loss above what the line loses anyway that means congestion, if the window limits the sender and if it does not; and up to which
	/// the window grows.
	static constexpr double LOSS_MARGIN = 0.1;
	static constexpr double UNLIMITED_LOSS_MARGIN = 0.35;
	static constexpr double GROWTH_LOSS_MARGIN = 0.05;
	/// Bytes over which loss is measured: fewer suffice for a loss above OBVIOUS_LOSS.
	static constexpr double LOSS_SPAN = 64 * PACKET;
	static constexpr double OBVIOUS_LOSS_SPAN = 12 * PACKET;
	static constexpr double OBVIOUS_LOSS = 0.5;
	/// The share of a loss that remains after a reduction if the loss does not depend on what is sent.
	static constexpr double REMAINING = 0.6;
	/// After so many seconds without an acknowledgement, the line was interrupted.
	static constexpr double OUTAGE = 1.0;
	static constexpr double LOSS_FORGOTTEN = 0.2; // of the background loss, per measurement
	/// Seconds and acknowledgements of an epoch, at least.
	static constexpr double MIN_EPOCH = 0.1;
	static constexpr int MIN_ACKNOWLEDGEMENTS = 4;
	static constexpr double MAX_EPOCH = 1.0;
	static constexpr double BASE_SPAN = 15.0; // seconds
	static constexpr double DELIVERED_SPAN = 2.0; // seconds
	static constexpr double SMOOTH_SPAN = 0.5; // seconds
	/// The average is low after losses, the maximum high after a burst: at least this part of the maximum.
	static constexpr double MIN_DELIVERED_SHARE = 0.7;

	bool _is_validated = false;
	size_t _in_flight = 0;
	double _window = INITIAL_WINDOW;
	bool _is_slow_start = true;
	bool _is_limited = false; // in this epoch
	bool _was_limited = false; // in the last one
	RecentExtreme _base{ -1.0, BASE_SPAN }; // round trip
	RecentExtreme _delivered{ 1.0, DELIVERED_SPAN }; // bytes per second
	double _smooth_delivered = 0.0; // bytes per second, averaged over SMOOTH_SPAN
	double _round_trip = 0.0; // smallest of the last epoch
	Epoch _epoch;
	int _cuts = 0; // reductions in a row
	double _cut_round_trip = 0.0; // at the first of them
	double _tokens = 0.0; // bytes that may be sent, after the line has shown its limit
	double _tokens_at = 0.0; // time
	double _lost = 0.0; // bytes, since loss was last judged
	double _arrived = 0.0; // bytes, the same
	double _background_loss = 0.0; // that does not depend on what is sent
	double _cut_loss = 0.0; // at the last reduction because of loss; 0: its effect is known
	double _cut_window = 0.0; // before it
	double _cut_at = -1.0; // time of the last reduction: what was sent before says nothing about its effect
	double _acknowledged_at = -1e9; // time of the last acknowledgement
	double _lost_in_row = 0.0; // bytes, since the last acknowledgement
};

} // namespace net
