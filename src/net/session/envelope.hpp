#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

// What stands before the packets of one node among several that share a transport, and among a game's own packets.
//
//   u8   0x40 | ENVELOPE_VERSION << 2 | kind
//   u16  key: which nodes, the same on all peers; little endian
//   u8   link: which stream to this receiver; chosen by the receiver, another one for each stream
//   ...  MOTION: a packet of net::Sender; ANSWER: one of net::Receiver; BYE: u8, 1 if the stream's sender ends it, 0 if
//        its receiver does; HELLO: nothing

namespace net {

enum class PacketKind : uint8_t {
	OPEN, ///< a receiver asks the authority for its stream
	CLOSE, ///< a stream has ended
	MOTION,
	ACK,
};

struct Envelope {
	PacketKind kind = PacketKind::OPEN;
	uint16_t key = 0;
	uint8_t link = 0;
	uint8_t version = 0; ///< of the peer that sent it
};

inline constexpr size_t ENVELOPE_BYTES = 4;
inline constexpr uint8_t ENVELOPE_VERSION = 1; ///< 0 to 3

/// Writes ENVELOPE_BYTES bytes, of this version.
void write_envelope(const Envelope &envelope, uint8_t *bytes);
/// False if the packet does not begin with an envelope; then it is somebody else's.
[[nodiscard]] bool read_envelope(const uint8_t *bytes, size_t size, Envelope &envelope);

/// 32-bit FNV-1a of a node's path: names that are the same on all peers as numbers.
[[nodiscard]] uint32_t path_hash(std::string_view utf8);
/// The key of a node that sends packets.
[[nodiscard]] uint16_t path_key(std::string_view utf8);
/// The id of a body, 31 bits.
[[nodiscard]] uint32_t path_body(std::string_view utf8);

} // namespace net
