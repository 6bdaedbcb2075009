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
/// Copa (Arun and Balakrishnan, 2018). Loss counts only if it falls when less is sent: a line that loses a part of all packets is
/// not congested.
///
/// Before the first acknowledgement, all bytes sent can be limited as well, so that a receiver with a forged address gets little
/// (RFC 9000, section 8.1). Times in seconds.
class CongestionControl {
public:
	/// Limits what is sent before the first acknowledgement to `bytes`.
	void limit_credit(size_t bytes) { _credit = bytes; }
	void add_credit(size_t bytes) { _credit += std::min(bytes, NO_LIMIT - _credit); }

	/// Bytes that may be sent now.
	[[nodiscard]] size_t allowance() const;
	/// The sender has more to send than the window allows.
	void set_limited() { _is_limited = true; }

	void sent(size_t bytes) {
		_in_flight += bytes;
		spend(bytes);
	}
	/// Bytes are sent that are not acknowledged.
	void spend(size_t bytes) { _credit -= _is_validated || _credit == NO_LIMIT ? 0 : std::min(bytes, _credit); }
	/// `bytes` in flight are known to have left the network: acknowledged, or lost.
	void left(size_t bytes) { _in_flight -= std::min(bytes, _in_flight); }
	/// The receiver has acknowledged `bytes`. `round_trip` is that of the newest acknowledged packet, 0 if it is unknown.
	void acknowledged(size_t bytes, double round_trip, double loss, double time);

	/// Bytes per second that the line carries, as far as known: more if the window has not limited the sender lately.
	[[nodiscard]] double rate() const;
	/// True if the window has limited the sender in the last two round trips.
	[[nodiscard]] bool is_limiting() const { return _was_limited || _is_limited; }
	[[nodiscard]] bool is_validated() const { return _is_validated; }

private:
	struct Epoch {
		double begin = 0.0;
		double min_round_trip = 0.0; // 0: no sample
		int samples = 0;
		size_t delivered = 0;
	};

	void finish_epoch(double loss, double time);
	/// Reduces the window to what was delivered in `seconds`.
	void reduce(double delivered_rate, double seconds);
	/// True if the queue remains although less is sent: then it is not ours, or the route has become longer.
	[[nodiscard]] bool is_longer_route() const { return _cuts >= MAX_CUTS && _epoch.min_round_trip > 0.9 * _cut_round_trip; }

	static constexpr size_t NO_LIMIT = ~size_t(0);
	static constexpr double PACKET = 1200.0;
	static constexpr double INITIAL_WINDOW = 24 * PACKET;
	static constexpr double MIN_WINDOW = 4 * PACKET;
	static constexpr double MAX_WINDOW = 16e6;
	/// Growth per round trip after the first reduction.
	static constexpr double GROWTH = 0.08;
	/// Maximum queueing delay, in seconds and as a fraction of the round trip.
	static constexpr double MAX_QUEUE = 0.05;
	static constexpr double MAX_QUEUE_SHARE = 0.25;
	/// Reductions in a row after which a queueing delay that remains counts as a longer route.
	static constexpr int MAX_CUTS = 3;
	/// Loss above what the line loses anyway that means congestion.
	static constexpr double LOSS_MARGIN = 0.08;
	/// Seconds and samples of an epoch, at least.
	static constexpr double MIN_EPOCH = 0.1;
	static constexpr int MIN_SAMPLES = 4;
	static constexpr double MAX_EPOCH = 1.0;
	static constexpr double BASE_SPAN = 15.0; // seconds

	size_t _credit = NO_LIMIT;
	bool _is_validated = false;
	size_t _in_flight = 0;
	double _window = INITIAL_WINDOW;
	bool _is_slow_start = true;
	bool _is_limited = false; // in this epoch
	bool _was_limited = false; // in the last one
	RecentExtreme _base{ -1.0, BASE_SPAN }; // round trip
	double _round_trip = 0.0; // smallest of the last epoch
	Epoch _epoch;
	int _cuts = 0; // reductions in a row
	double _cut_round_trip = 0.0; // at the first of them
	double _background_loss = 0.0; // that does not depend on what is sent
	double _cut_loss = 0.0; // at the last reduction because of loss; 0: none is being tested
	double _cut_window = 0.0; // before it
	int _test_epochs = 0; // left until the effect of that reduction is known
};

} // namespace net
