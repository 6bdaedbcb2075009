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

bool read_envelope(const uint8_t *bytes, size_t size, Envelope &envelope) {
	if (size < ENVELOPE_BYTES || (bytes[0] & MARK_BITS) != MARK) {
		return false;
	}
	envelope.kind = PacketKind(bytes[0] & 3);
	envelope.version = (bytes[0] >> 2) & 3;
	envelope.key = uint16_t(bytes[1] | bytes[2] << 8);
	envelope.link = bytes[3];
	return true;
}

uint32_t path_hash(std::string_view utf8) {
	uint32_t hash = 2166136261u;
	for (const char byte : utf8) {
		hash = (hash ^ uint8_t(byte)) * 16777619u;
	}
	return hash;
}

uint16_t path_key(std::string_view utf8) {
	const uint32_t hash = path_hash(utf8);
	return uint16_t(hash ^ hash >> 16);
}

uint32_t path_body(std::string_view utf8) {
	const uint32_t hash = path_hash(utf8);
	return (hash ^ hash >> 31) & 0x7fffffffu;
}

} // namespace net
