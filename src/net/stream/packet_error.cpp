#include "net/stream/packet_error.hpp"

namespace net {

const char *describe(PacketError error) {
	switch (error) {
		case PacketError::EMPTY:
			return "the packet is empty";
		case PacketError::TOO_LONG:
			return "the packet exceeds the maximum packet size";
		case PacketError::TRUNCATED:
			return "the packet is truncated";
		case PacketError::UNKNOWN_ITEM:
			return "the packet contains an item of unknown type";
		case PacketError::BAD_ACK:
			return "the length of the packet's acknowledgement mask is not 1 to 8 bytes";
		case PacketError::BAD_FRAGMENT:
			return "a snapshot fragment is empty or its index is out of range";
		case PacketError::TOO_MANY_BODIES:
			return "the snapshot is larger than the maximum number of bodies allows";
		case PacketError::TRUNCATED_SNAPSHOT:
			return "the snapshot is truncated";
		case PacketError::UNREADABLE_SNAPSHOT:
			return "the snapshot cannot be decoded";
		case PacketError::OTHER_STREAM_VERSION:
			return "the stream format is of another version of the addon; use the same version on all peers";
		case PacketError::UNKNOWN_MODE:
			return "the snapshot's interpolation mode is unknown";
		case PacketError::SETTINGS_OUT_OF_RANGE:
			return "the snapshot's settings are out of range";
		case PacketError::UNKNOWN_RECEIVER:
			return "the acknowledgement comes from a peer that is not a receiver";
		case PacketError::OTHER_SESSION_VERSION:
			return "the packet is of another version of the addon; use the same version on all peers";
		case PacketError::MALFORMED_CLOSE:
			return "the close packet is malformed";
		case PacketError::STREAM_NOT_REQUESTED:
			return "the packet belongs to a stream that was not requested";
		case PacketError::SENDER_OWNS_NOTHING:
			return "its sender is not the authority of any target here";
		case PacketError::NOT_SUBSCRIBED:
			return "it acknowledges a stream that its sender does not receive";
	}
	return "unknown error";
}

} // namespace net
