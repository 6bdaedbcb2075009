#pragma once

#include "net/stream/packet_error.hpp"
#include "net/stream/stream_settings.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// Version of the stream format. A receiver rejects any other.
inline constexpr uint8_t STREAM_VERSION = 1;

/// The header of a snapshot.
struct SnapshotHeader {
	static constexpr size_t TICK_BYTES = 6; ///< at 60 Hz, enough for 148,000 years
	static constexpr size_t MIN_BYTES = 32;
	static constexpr size_t MAX_BYTES = 36;

	StreamSettings settings; ///< send_rate and max_packet_size are not transmitted
	uint64_t tick = 0; ///< the snapshot's media time; only TICK_BYTES are transmitted
	float window = 0.0f; ///< the sender's maximum window length, in seconds

	/// position_tolerance_2d is transmitted only if it is not the default.
	[[nodiscard]] bool has_tolerance_2d() const { return float(settings.position_tolerance_2d) != float(StreamSettings().position_tolerance_2d); }
	[[nodiscard]] size_t bytes() const { return has_tolerance_2d() ? MAX_BYTES : MIN_BYTES; }
};

void put_snapshot_header(std::vector<uint8_t> &bytes, const SnapshotHeader &header);
/// Parses a header at the start of `bytes`. Fails if it is truncated or out of range.
cga::Result<SnapshotHeader, PacketError> read_snapshot_header(const uint8_t *bytes, size_t size);

} // namespace net
