// The envelope of a session's packet, and the sections of a relayed one.

#include "../input.hpp"

#include "net/session/envelope.hpp"
#include "net/session/section.hpp"

void fuzz::run(Input input) {
	const Bytes bytes = input.rest();
	if (const auto envelope = net::read_envelope(bytes.data(), bytes.size())) {
		uint8_t written[net::ENVELOPE_BYTES];
		net::write_envelope(*envelope, written);
		const auto again = net::read_envelope(written, sizeof(written));
		require(again && again->kind == envelope->kind && again->link == envelope->link, "an envelope differs after it was written and read");
	}
	Bytes written;
	size_t end = 0;
	(void)net::read_sections(bytes.data(), bytes.size(), [&](const net::Section &section) {
		require(section.begin >= end && section.size <= bytes.size() && section.begin + section.size <= bytes.size(), "a section is not in the packet");
		require(section.owner >= 0 && section.channel < net::Section::CHANNEL_LIMIT, "a section is out of range");
		end = section.begin + section.size;
		written.clear();
		net::put_section_header(written, section, false);
		written.insert(written.end(), bytes.begin() + ptrdiff_t(section.begin), bytes.begin() + ptrdiff_t(end));
		size_t count = 0;
		(void)net::read_sections(written.data(), written.size(), [&](const net::Section &again) {
			require(again.channel == section.channel && again.owner == section.owner && again.size == section.size, "a section differs after it was written and read");
			++count;
			return net::PacketResult();
		});
		require(count == 1, "a written section is read as several");
		return net::PacketResult();
	});
}
