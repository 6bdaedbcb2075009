#pragma once

#include "net/endpoint/work_budget.hpp"

#include <cstddef>
#include <memory>
#include <utility>

namespace net {

/// Limits what a sender can make a receiver do, in items of packets, snapshots and work of decoding (decoding_work.hpp). Decoding waits
/// while the work is spent. A stream that sends too many items, or for which decoding waits too long, is refused for a pause.
class ReceiverBudget {
public:
	/// Seconds for which decoding may wait.
	static constexpr double MAX_WAIT = 5.0;
	/// Pause after the first refusal and maximum, in seconds. Each is twice as long as the one before.
	static constexpr double FIRST_PAUSE = 0.25;
	static constexpr double MAX_PAUSE = 30.0;
	/// Work per second for any stream, for each of its bodies, and at most. 40,000 bodies that move cost 14 million in 20 windows per
	/// second.
	static constexpr double MIN_WORK = 4e6;
	static constexpr double BODY_WORK_RATE = 2400.0;
	static constexpr double MAX_WORK = 32e6;
	/// Seconds of work that can be done at once.
	static constexpr double BURST = 0.1;

	/// `shared` is spent by all receivers that share it; null for none.
	explicit ReceiverBudget(std::shared_ptr<WorkBudget> shared) :
			_shared(std::move(shared)) {}

	/// The rate for a stream or several of `bodies` bodies.
	[[nodiscard]] static double work_rate(size_t bodies);

	/// Refills everything at `now`. `bodies` is the number of bodies in the stream.
	void refill(double now, size_t bodies);
	void spend_items(size_t count) { _items.spend(double(count)); }
	void spend_work(size_t work);
	/// Counts a snapshot that begins. Returns false if it must be ignored, as too many have begun.
	[[nodiscard]] bool begin_snapshot();
	[[nodiscard]] bool must_wait() const { return _work.is_spent() || (_shared != nullptr && _shared->is_spent()); }
	/// True if `work` should not be done before the frame ends.
	[[nodiscard]] bool is_costly(size_t work) const { return _shared != nullptr && double(work) > _shared->max_prompt(); }
	/// Records whether something waits to be decoded since the last call.
	void note_waiting(bool is_waiting, double now);
	[[nodiscard]] bool is_waiting() const { return _is_waiting; }
	[[nodiscard]] bool is_exceeded() const { return _items.is_spent() || _snapshots.is_overdrawn(MAX_IGNORED_SNAPSHOTS) || _waited > MAX_WAIT; }

	/// Refuses the stream for a pause from `now` on.
	void refuse(double now);
	[[nodiscard]] bool is_refused() const { return _is_refused; }
	/// Total work spent.
	[[nodiscard]] double total_work() const { return _total; }

private:
	static constexpr double MAX_IGNORED_SNAPSHOTS = 32.0;

	WorkBudget _items{ 16384.0, 2.0 };
	WorkBudget _snapshots{ 4.0, 1.0 };
	WorkBudget _work{ MIN_WORK, BURST };
	std::shared_ptr<WorkBudget> _shared;
	double _total = 0.0;
	bool _is_waiting = false;
	double _waited = 0.0; // seconds since decoding last waited for nothing
	double _noted_at = 0.0;
	bool _is_refused = false;
	double _refused_at = 0.0;
	double _pause = 0.0; // after the last refusal
};

} // namespace net
