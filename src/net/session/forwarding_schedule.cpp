#include "net/session/forwarding_schedule.hpp"

#include <cmath>

namespace net {

namespace {

/// The latest windows should arrive this long before an instant, or a little later or earlier, in ticks.
constexpr double GOAL = 0.25;
constexpr double LATE_TOLERANCE = 0.3;
constexpr double TOLERANCE = 0.6;
/// The tolerance for an owner that is aligned, if its arrivals vary by MIN_SPREAD or more.
constexpr double KEPT_TOLERANCE = 0.8;
constexpr double MIN_SPREAD = 0.05;
/// A window that is later than all others by this is an exception, for example a retransmission. In ticks.
constexpr double FAR = 1.5;
/// Factor by which maxima decay from measurement to measurement.
constexpr double DECAY = 0.9;
/// Seconds until a request has taken effect, besides two periods.
constexpr double SETTLING_TIME = 0.2;
/// The same if the windows did not arrive with the requested period: they do so from now on, or cannot.
constexpr double UNSTEADY_TIME = 1.0;

} // namespace

std::optional<AlignItem> WindowAligner::take_request(double period, double tick, double now) {
	if (_count < COUNT) {
		return std::nullopt;
	}
	_count = 0;
	std::sort(_lengths.begin(), _lengths.end());
	// An owner whose windows are shorter divides the period.
	const double interval = period / std::max(std::round(period / std::max(_lengths[COUNT / 2], tick)), 1.0);
	// Leads are positions on a circle: measure from the one that is closest to all others.
	std::array<double, COUNT> offsets{};
	double least_sum = 1e9;
	double center = 0.0;
	for (const double middle : _leads) {
		std::array<double, COUNT> from_middle = _leads;
		double sum = 0.0;
		for (double &offset : from_middle) {
			offset = std::remainder(offset - middle, interval);
			sum += std::fabs(offset);
		}
		if (sum < least_sum) {
			least_sum = sum;
			offsets = from_middle;
			center = middle;
		}
	}
	std::sort(offsets.begin(), offsets.end());
	const double latest = offsets[1] - offsets[0] < FAR * tick ? offsets[0] : offsets[1];
	const double shift = std::remainder(center + latest - GOAL * tick, interval);
	const double spread = offsets[COUNT - 1] - latest;
	_spread = interval == _interval ? std::max(spread, DECAY * _spread) : spread;
	_interval = interval;
	const bool is_periodic = spread <= 0.5 * interval;
	const double tolerance = _is_aligned && _spread >= MIN_SPREAD * tick ? KEPT_TOLERANCE : TOLERANCE;
	_is_aligned = is_periodic && shift >= -LATE_TOLERANCE * tick && shift <= tolerance * tick;
	if (_is_aligned) {
		_max_lead = std::max(shift + GOAL * tick + spread, DECAY * _max_lead);
		return std::nullopt;
	}
	_settled_at = now + (is_periodic ? SETTLING_TIME : UNSTEADY_TIME) + 2.0 * period;
	return AlignItem{ ++_number, period, shift };
}

} // namespace net
