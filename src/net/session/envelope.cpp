#include "net/session/envelope.hpp"

namespace net {

static constexpr uint8_t MARK = 0x40;
static constexpr uint8_t MARK_BITS = 0xf0;

void write_envelope(const Envelope &envelope, uint8_t *bytes) {
	bytes[0] = uint8_t(MARK | ENVELOPE_VERSION << 2 | uint8_t(envelope.kind));
	bytes[1] = uint8_t(envelope.key);
	bytes[2] = uint8_t(envelope.key >> 8);
	bytes[3] = envelope.link;
}

std::optional<Envelope> read_envelope(const uint8_t *bytes, size_t size) {
	if (size < ENVELOPE_BYTES || (bytes[0] & MARK_BITS) != MARK) {
		return std::nullopt;
	}
	Envelope envelope;
	envelope.kind = PacketKind(bytes[0] & 3);
	envelope.version = (bytes[0] >> 2) & 3;
	envelope.key = uint16_t(bytes[1] | bytes[2] << 8);
	envelope.link = bytes[3];
	return envelope;
}

} // namespace net
