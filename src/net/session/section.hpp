#pragma once

#include "net/session/outbox.hpp"
#include "net/stream/packet_error.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

// Packets between a relaying server and its clients consist of sections. docs/wire-format.md describes them byte by byte.

namespace net {

/// A packet of one of the streams that share a packet. Its bytes are in a buffer of the caller.
struct Section {
	/// The channel of the server's own stream. Other owners' streams have other channels, from 1 on.
	static constexpr uint32_t SERVER_CHANNEL = 0;
	static constexpr uint32_t CHANNEL_LIMIT = 65536;
	/// Maximum size of a section's header, in bytes.
	static constexpr size_t HEADER = 9;

	uint32_t channel = SERVER_CHANNEL;
	PeerId owner = 0; ///< of the stream; 0 once the client knows it
	size_t begin = 0; ///< offset in the buffer
	size_t size = 0;
};

inline void put_section_header(std::vector<uint8_t> &packet, const Section &section, bool is_last) {
	uint32_t code = section.channel << 2 | (section.owner != 0 ? 2 : 0) | (is_last ? 0 : 1);
	for (; code >= 128; code >>= 7) {
		packet.push_back(uint8_t(code | 128));
	}
	packet.push_back(uint8_t(code));
	for (int shift = 0; section.owner != 0 && shift < 32; shift += 8) {
		packet.push_back(uint8_t(uint32_t(section.owner) >> shift));
	}
	if (!is_last) {
		packet.push_back(uint8_t(section.size));
		packet.push_back(uint8_t(section.size >> 8));
	}
}

/// Packs sections into few packets of at most `max_size` bytes (first fit, the largest first) and calls send(bytes, size) for
/// each. A section that is too large alone gets a packet of its own. Clears `sections`.
template <class Send>
void pack_sections(std::vector<Section> &sections, const std::vector<uint8_t> &bytes, size_t max_size, std::vector<uint8_t> &packet, Send &&send) {
	std::sort(sections.begin(), sections.end(), [](const Section &a, const Section &b) { return a.size != b.size ? a.size > b.size : a.begin < b.begin; });
	std::vector<Section> rest;
	while (!sections.empty()) {
		packet.clear();
		rest.clear();
		size_t used = 0;
		size_t count = 0;
		for (const Section &section : sections) {
			if (count > 0 && used + section.size + Section::HEADER > max_size) {
				rest.push_back(section);
				continue;
			}
			used += section.size + Section::HEADER;
			sections[count++] = section;
		}
		for (size_t i = 0; i < count; ++i) {
			put_section_header(packet, sections[i], i + 1 == count);
			packet.insert(packet.end(), bytes.begin() + ptrdiff_t(sections[i].begin), bytes.begin() + ptrdiff_t(sections[i].begin + sections[i].size));
		}
		send(packet.data(), packet.size());
		sections.swap(rest);
	}
}

/// Calls read(section) for each section of a packet; their offsets are those in `bytes`. Stops at the first that is malformed.
template <class Read>
PacketResult read_sections(const uint8_t *bytes, size_t size, Read &&read) {
	if (size == 0) {
		return PacketError::EMPTY;
	}
	PacketResult result;
	for (size_t at = 0; at < size;) {
		uint32_t code = 0;
		for (int shift = 0;; shift += 7) {
			if (at == size || shift > 14) {
				return PacketError::BAD_SECTION;
			}
			const uint8_t byte = bytes[at++];
			code |= uint32_t(byte & 127) << shift;
			if (byte < 128) {
				break;
			}
		}
		Section section{ code >> 2 };
		const bool has_owner = (code & 2) != 0;
		const bool has_size = (code & 1) != 0;
		if (section.channel >= Section::CHANNEL_LIMIT || size - at < (has_owner ? 4u : 0u) + (has_size ? 2u : 0u)) {
			return PacketError::BAD_SECTION;
		}
		for (int shift = 0; has_owner && shift < 32; shift += 8) {
			section.owner = PeerId(uint32_t(section.owner) | uint32_t(bytes[at++]) << shift);
		}
		section.size = has_size ? size_t(bytes[at] | bytes[at + 1] << 8) : size - at;
		section.begin = at + (has_size ? 2 : 0);
		if (section.size > size - section.begin || (has_owner && section.owner <= 0)) {
			return PacketError::BAD_SECTION;
		}
		at = section.begin + section.size;
		const PacketResult read_result = read(section);
		result = result ? read_result : result;
	}
	return result;
}

} // namespace net
