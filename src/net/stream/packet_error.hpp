#pragma once

#include "cga/result.hpp"

#include <cstdint>
#include <iterator>

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
	TOO_MUCH_WORK,
	// Detected by senders.
	UNKNOWN_RECEIVER,
	// Detected by sessions.
	OTHER_SESSION_VERSION,
	MALFORMED_CLOSE,
	STREAM_NOT_REQUESTED,
	NOT_SUBSCRIBED,
	BAD_SECTION,
	TOO_MANY_STREAMS,
	UNAUTHORIZED_BODIES,
	RELAY_DIFFERS,
	MALFORMED_OPEN,
	ABSENT_BODIES,
	TOO_MANY_PACKETS,
};

/// Describes the reason as a clause without a period.
[[nodiscard]] inline const char *describe(PacketError error) {
	// In the order of the enumerators.
	static constexpr const char *DESCRIPTIONS[] = {
		"the packet is empty",
		"the packet exceeds the maximum packet size",
		"the packet is truncated",
		"the packet contains an item of unknown type",
		"the packet's acknowledgement is malformed",
		"a snapshot fragment is too small or its index is out of range",
		"the snapshot is larger than the maximum number of bodies allows",
		"the snapshot is truncated",
		"the snapshot cannot be decoded",
		"the stream format is of another version of the addon; use the same version on all peers",
		"the snapshot's interpolation mode is unknown",
		"the snapshot's settings are out of range",
		"decoding the stream takes more work than its number of bodies allows; it is ignored and requested again later",
		"the acknowledgement comes from a peer that is not a receiver",
		"the packet is of another version of the addon; use the same version on all peers",
		"the close packet is malformed",
		"the packet belongs to a stream that was not requested",
		"it acknowledges a stream that its sender does not receive",
		"the header of a section of the packet is malformed",
		"the server relays the streams of too many owners",
		"its stream contains bodies of other owners, so it is not relayed until it no longer does",
		"`relay` is on at one of the two peers and off at the other; set it to the same value on all peers",
		"the open packet is malformed",
		"its stream contains more than 64 bodies that do not exist at the server, so it is not relayed until it no longer does",
		"the peer sends more packets than its number of bodies allows; all of them are ignored until it sends fewer",
	};
	static_assert(std::size(DESCRIPTIONS) == size_t(PacketError::TOO_MANY_PACKETS) + 1);
	return DESCRIPTIONS[size_t(error)];
}

/// Success, or why a packet was rejected.
using PacketResult = cga::Result<void, PacketError>;

} // namespace net
