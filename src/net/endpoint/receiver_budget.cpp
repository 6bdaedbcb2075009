#include "net/endpoint/receiver_budget.hpp"

#include <algorithm>

namespace net {

namespace {

/// Of a longer time between two calls, in seconds, only so much counts as waiting: the receiver itself stood still.
constexpr double MAX_STEP = 0.25;
/// After so many seconds, a refusal no longer makes the next pause longer.
constexpr double REFUSAL_MEMORY = 120.0;

} // namespace

double ReceiverBudget::work_rate(size_t bodies) {
	return std::min(MIN_WORK + BODY_WORK_RATE * double(bodies), MAX_WORK);
}

void ReceiverBudget::refill(double now, size_t bodies) {
	_work.set_rate(work_rate(bodies));
	_work.refill(now);
	_items.refill(now);
	_snapshots.refill(now);
	if (_shared != nullptr) {
		_shared->refill(now);
	}
	if (_is_refused && (now - _refused_at >= _pause || now < _refused_at)) {
		_is_refused = false;
	}
}

void ReceiverBudget::spend_work(size_t work) {
	_total += double(work);
	_work.spend(double(work));
	if (_shared != nullptr) {
		_shared->spend(double(work));
	}
}

bool ReceiverBudget::begin_snapshot() {
	const bool is_allowed = !_snapshots.is_spent();
	_snapshots.spend(1.0);
	return is_allowed;
}

void ReceiverBudget::note_waiting(bool is_waiting, double now) {
	if (is_waiting) {
		_waited += _is_waiting ? std::clamp(now - _noted_at, 0.0, MAX_STEP) : 0.0;
	} else {
		_waited = 0.0;
	}
	_is_waiting = is_waiting;
	_noted_at = now;
}

void ReceiverBudget::refuse(double now) {
	const bool is_first = _pause == 0.0 || now - _refused_at > REFUSAL_MEMORY;
	_pause = is_first ? FIRST_PAUSE : std::min(2.0 * _pause, MAX_PAUSE);
	_refused_at = now;
	_is_refused = true;
	_is_waiting = false;
	_waited = 0.0;
	for (WorkBudget *budget : { &_items, &_snapshots, &_work }) {
		budget->forgive();
	}
}

} // namespace net
