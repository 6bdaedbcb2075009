#pragma once

#include "net/stream/packet_error.hpp"

#include <cstdint>
#include <optional>

namespace net {

/// Counts the rejected packets of one peer and rate-limits their reports. Counting must be cheap, as a hostile
/// peer can trigger it at any rate.
class Rejections {
public:
	struct Report {
		PacketError error; ///< of the last rejected packet
		uint64_t count; ///< since the last report
	};

	void add(PacketError error) {
		_error = error;
		++_count;
		++_unreported;
	}
	[[nodiscard]] uint64_t count() const { return _count; }
	/// Returns the unreported rejections, at most once per INTERVAL.
	[[nodiscard]] std::optional<Report> take_report(double now) {
		if (_unreported == 0 || now - _reported_at < INTERVAL) {
			return std::nullopt;
		}
		const Report report{ _error, _unreported };
		_unreported = 0;
		_reported_at = now;
		return report;
	}

private:
	static constexpr double INTERVAL = 0.5; // seconds

	PacketError _error = PacketError::EMPTY;
	uint64_t _count = 0;
	uint64_t _unreported = 0;
	double _reported_at = -1e9;
};

} // namespace net
