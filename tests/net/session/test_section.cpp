#include "net/session/section.hpp"

#include <doctest/doctest.h>

#include <map>
#include <utility>

using namespace net;

TEST_CASE("section: sections are packed into few packets and read back") {
	std::vector<uint8_t> bytes;
	std::vector<Section> sections;
	for (uint32_t i = 0; i < 40; ++i) {
		const Section section{ i * i * 40, i % 3 == 0 ? PeerId(0x7fffffff - i) : 0, bytes.size(), 1 + (i * 37) % 300 };
		sections.push_back(section);
		bytes.resize(bytes.size() + section.size, uint8_t(i));
	}
	std::map<uint32_t, Section> wanted;
	for (const Section &section : sections) {
		wanted[section.channel] = section;
	}
	const size_t total = bytes.size();
	size_t packets = 0;
	std::vector<uint8_t> packet;
	pack_sections(sections, bytes, 1000, packet, [&](const uint8_t *content, size_t size) {
		++packets;
		CHECK(size <= 1000);
		CHECK(read_sections(content, size, [&](const Section &section) {
			const Section expected = wanted.at(section.channel);
			CHECK(section.owner == expected.owner);
			REQUIRE(section.size == expected.size);
			CHECK(std::equal(content + section.begin, content + section.begin + section.size, bytes.begin() + ptrdiff_t(expected.begin)));
			wanted.erase(section.channel);
			return PacketResult();
		}));
	});
	CHECK(wanted.empty());
	CHECK(sections.empty());
	CHECK(packets <= total / 1000 + 2);
}

TEST_CASE("section: a section that is alone takes one byte more than its content, or a packet of its own if it is too large") {
	for (const size_t size : { size_t(1), size_t(50), size_t(5000) }) {
		std::vector<Section> sections = { { 31, 0, 0, size } };
		std::vector<uint8_t> packet;
		int packets = 0;
		pack_sections(sections, std::vector<uint8_t>(size), 1000, packet, [&](const uint8_t *, size_t packet_size) {
			++packets;
			CHECK(packet_size == size + 1);
		});
		CHECK(packets == 1);
	}
}

TEST_CASE("section: malformed headers are rejected, errors of the content are returned") {
	const auto read = [](const std::vector<uint8_t> &packet) { return read_sections(packet.data(), packet.size(), [](const Section &section) { return section.size == 3 ? PacketResult(PacketError::BAD_ACK) : PacketResult(); }); };
	CHECK(read({}).error() == PacketError::EMPTY);
	for (const std::vector<uint8_t> &packet : std::vector<std::vector<uint8_t>>{
				 { 0x80 }, // truncated channel
				 { 0x80, 0x80, 0x80, 0x01 }, // channel of four bytes
				 { 0xfc, 0xff, 0x7f }, // channel above the limit
				 { 0x02, 1, 0, 0 }, // truncated owner
				 { 0x02, 0, 0, 0, 0 }, // owner 0
				 { 0x02, 0, 0, 0, 0x80 }, // negative owner
				 { 0x01, 2 }, // truncated size
				 { 0x01, 2, 0, 7 }, // truncated content
				 { 0x01, 1, 0, 7, 0x80 }, // the second one is malformed
		 }) {
		CHECK(read(packet).error() == PacketError::BAD_SECTION);
	}
	CHECK(read({ 0x04 }));
	CHECK(read({ 0x01, 1, 0, 7, 0x04, 7, 7 }));
	CHECK(read({ 0x01, 3, 0, 7, 7, 7, 0x04 }).error() == PacketError::BAD_ACK);
}
