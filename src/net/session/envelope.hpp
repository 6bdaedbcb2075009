#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

// The header of each session packet. It distinguishes sessions that share a transport, and session packets from game packets.
//
//   u8   0x40 | ENVELOPE_VERSION << 2 | kind
//   u16  key of the session, the same on all peers, little-endian
//   u8   link: number of the stream to this receiver, chosen by the receiver, different for each stream
//   ...  MOTION: a packet of net::Sender; ACK: a packet of net::Receiver; CLOSE: u8, a CloseRole; OPEN: nothing

namespace net {

enum class PacketKind : uint8_t {
	OPEN, ///< a receiver requests the authority's stream
	CLOSE, ///< a stream has ended
	MOTION,
	ACK,
};

/// The endpoint that closes a stream.
enum class CloseRole : uint8_t {
	RECEIVER,
	SENDER,
};

struct Envelope {
	PacketKind kind = PacketKind::OPEN;
	uint16_t key = 0;
	uint8_t link = 0;
	uint8_t version = 0; ///< protocol version of the sending peer
};

inline constexpr size_t ENVELOPE_BYTES = 4;
inline constexpr uint8_t ENVELOPE_VERSION = 1; ///< 0 to 3

/// Writes ENVELOPE_BYTES bytes, with ENVELOPE_VERSION.
void write_envelope(const Envelope &envelope, uint8_t *bytes);
/// Returns std::nullopt if the packet does not begin with an envelope and thus belongs to the game.
[[nodiscard]] std::optional<Envelope> read_envelope(const uint8_t *bytes, size_t size);

} // namespace net
