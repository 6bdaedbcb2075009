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
		PacketError error; ///< of the last packet that was rejected for its version; without one, of the last rejected packet
		uint64_t count; ///< since the last report
		uint8_t version; ///< the peer's, if the error is OTHER_SESSION_VERSION or OTHER_STREAM_VERSION
	};

	/// `version`: that of the peer, if it differs.
	void add(PacketError error, uint8_t version = 0) {
		++_count;
		++_unreported;
		const bool is_version = error == PacketError::OTHER_SESSION_VERSION || error == PacketError::OTHER_STREAM_VERSION;
		if (is_version || !_is_version_due) {
			_error = error;
			_version = version;
			_is_version_due = is_version;
		}
	}
	/// Counts a packet of a flood, which has been reported.
	void add_ignored() { ++_count; }
	[[nodiscard]] uint64_t count() const { return _count; }
	/// Returns the unreported rejections, at most once per INTERVAL.
	[[nodiscard]] std::optional<Report> take_report(double now) {
		if (_unreported == 0 || now - _reported_at < INTERVAL) {
			return std::nullopt;
		}
		const Report report{ _error, _unreported, _version };
		_unreported = 0;
		_is_version_due = false;
		_reported_at = now;
		return report;
	}

private:
	static constexpr double INTERVAL = 0.5; // seconds

	PacketError _error = PacketError::EMPTY;
	uint8_t _version = 0;
	bool _is_version_due = false; // _error is that of a version
	uint64_t _count = 0;
	uint64_t _unreported = 0;
	double _reported_at = -1e9;
};

} // namespace net
