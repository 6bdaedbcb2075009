#pragma once

#include "cga/result.hpp"

#include <cstdint>

namespace net {

/// Why a packet was rejected. A rejected packet leaves the decoded motion unchanged.
enum class PacketError : uint8_t {
	// Detected by senders and receivers.
	EMPTY,
	TOO_LONG,
	TRUNCATED,
	UNKNOWN_ITEM,
	BAD_ACK,
	// Detected by receivers.
	BAD_FRAGMENT,
	TOO_MANY_BODIES,
	TRUNCATED_SNAPSHOT,
	UNREADABLE_SNAPSHOT,
	OTHER_STREAM_VERSION,
	UNKNOWN_MODE,
	SETTINGS_OUT_OF_RANGE,
	// Detected by senders.
	UNKNOWN_RECEIVER,
	// Detected by sessions.
	OTHER_SESSION_VERSION,
	MALFORMED_CLOSE,
	STREAM_NOT_REQUESTED,
	SENDER_OWNS_NOTHING,
	NOT_SUBSCRIBED,
};

/// Describes the reason as a clause without a period.
[[nodiscard]] const char *describe(PacketError error);

/// Success, or why a packet was rejected.
using PacketResult = cga::Result<void, PacketError>;

} // namespace net
