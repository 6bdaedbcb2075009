#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

// The header of each session packet. It distinguishes them from the packets of the game.
// docs/wire-format.md describes it byte by byte.

namespace net {

enum class PacketKind : uint8_t {
	OPEN, ///< a receiver requests the peer's stream; content: flags, see OPEN_RELAY, then STREAM_VERSION, and the token if there is one (u16)
	CLOSE, ///< a stream has ended; content: a CloseRole; if a server ends a relayed stream, its channel as well
	MOTION, ///< content: a packet of net::Sender; if relayed, sections
	ACK, ///< content: a packet of net::Receiver; if relayed, sections
};

/// Flags in the first byte of an OPEN packet's content.
inline constexpr uint8_t OPEN_RELAY = 1; ///< it requests a relayed stream, or comes from a server that relays
inline constexpr uint8_t OPEN_CHALLENGE = 2; ///< it asks the peer to repeat its OPEN of this link with the token
inline constexpr uint8_t OPEN_TOKEN = 4; ///< it repeats the token
inline constexpr uint8_t OPEN_FLAGS = OPEN_RELAY | OPEN_CHALLENGE | OPEN_TOKEN;
inline constexpr size_t OPEN_BYTES = 2; ///< of the content without a token
inline constexpr size_t TOKEN_BYTES = 2;

/// The endpoint that closes a stream.
enum class CloseRole : uint8_t {
	RECEIVER,
	SENDER,
};

struct Envelope {
	PacketKind kind = PacketKind::OPEN;
	uint8_t link = 0; ///< number of the stream to the receiver, which chooses it; different for each stream
	uint8_t version = 0; ///< protocol version of the sending peer
};

inline constexpr size_t ENVELOPE_BYTES = 4;
inline constexpr uint8_t ENVELOPE_MARK = 0x40; ///< high four bits of the first byte
inline constexpr uint16_t ENVELOPE_KEY = 0xc6a1; ///< in the second and third byte
inline constexpr uint8_t ENVELOPE_VERSION = 1; ///< 0 to 3

/// Writes ENVELOPE_BYTES bytes, with ENVELOPE_VERSION.
inline void write_envelope(const Envelope &envelope, uint8_t *bytes) {
	bytes[0] = uint8_t(ENVELOPE_MARK | ENVELOPE_VERSION << 2 | uint8_t(envelope.kind));
	bytes[1] = uint8_t(ENVELOPE_KEY & 0xff);
	bytes[2] = uint8_t(ENVELOPE_KEY >> 8);
	bytes[3] = envelope.link;
}

/// Returns std::nullopt if the packet does not begin with an envelope and thus belongs to the game.
[[nodiscard]] inline std::optional<Envelope> read_envelope(const uint8_t *bytes, size_t size) {
	if (size < ENVELOPE_BYTES || (bytes[0] & 0xf0) != ENVELOPE_MARK || (bytes[1] | bytes[2] << 8) != ENVELOPE_KEY) {
		return std::nullopt;
	}
	return Envelope{ PacketKind(bytes[0] & 3), bytes[3], uint8_t((bytes[0] >> 2) & 3) };
}

} // namespace net
