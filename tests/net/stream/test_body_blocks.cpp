#include "net/stream/body_blocks.hpp"

#include "../stream_scene.hpp"
#include "net/stream/stream_decoder.hpp"
#include "net/stream/stream_encoder.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace net;
using namespace net_test;

namespace {

using Bytes = std::vector<uint8_t>;

PoseD at(double x) {
	PoseD pose;
	pose.translation.x = x;
	return pose;
}

/// An encoder with bodies 0 to `count` - 1 at rest, and a decoder that follows it.
struct Link {
	explicit Link(uint32_t count) {
		for (uint32_t id = 0; id < count; ++id) {
			REQUIRE(encoder.add_body(id, 0.0, at(id)));
		}
		encoder.start_at(0.0);
		join(decoder);
	}

	void join(StreamDecoder &other) {
		Bytes snapshot;
		encoder.encode_snapshot(snapshot);
		REQUIRE(other.read_snapshot(snapshot.data(), snapshot.size()));
	}
	void window(int ticks = 4) {
		bytes.clear();
		encoder.encode_window(end, ticks, bytes);
		REQUIRE(decode(decoder));
		end += ticks;
	}
	/// Decodes the last window, before `end` moves.
	bool decode(StreamDecoder &other) {
		return other.decode_window(bytes.data(), bytes.size(), { encoder.check(), 255 }, end, cga::Mode::SEPARATE, motions).has_value();
	}

	StreamEncoder encoder{ 0.005f, 1.4f, cga::Mode::SEPARATE };
	StreamDecoder decoder{ 0.005f, 1.4f, 100000 };
	Bytes bytes;
	std::vector<BodyMotion> motions;
	double end = 0.0;
};

constexpr uint32_t BLOCK = uint32_t(BodyBlocks::SIZE);

} // namespace

TEST_CASE("body blocks: the work of a window is that of the blocks in which something moves") {
	size_t at_rest[2];
	for (const uint32_t blocks : { 4u, 200u }) {
		Link link(blocks * BLOCK);
		link.window();
		at_rest[blocks == 4 ? 0 : 1] = link.decoder.work();
		CHECK(link.motions.empty());
		CHECK(link.bytes.size() <= 12);
		CHECK(link.encoder.observe(2 * BLOCK + 5, link.end + 2.0, at(517.05)));
		link.window();
		CHECK((link.motions.size() == 1 || link.motions.size() == 2));
		CHECK(std::all_of(link.motions.begin(), link.motions.end(), [](const BodyMotion &motion) { return motion.id == 2 * BLOCK + 5; }));
		CHECK(link.decoder.work() <= at_rest[blocks == 4 ? 0 : 1] + BLOCK + 2 * SEGMENT_WORK);
	}
	CHECK(at_rest[1] - at_rest[0] <= 200);
}

TEST_CASE("body blocks: lists of one block contain no flags, and the number of bodies may pass the limit in both directions") {
	Link link(BLOCK - 10);
	cga_test::Random random(5);
	uint32_t next = BLOCK - 10;
	std::vector<uint32_t> ids;
	ids.reserve(next);
	for (uint32_t id = 0; id < next; ++id) {
		ids.push_back(id);
	}
	for (int i = 0; i < 200; ++i) {
		const bool grows = i % 40 < 20;
		for (int k = 0; k < 5; ++k) {
			if (grows) {
				REQUIRE(link.encoder.add_body(next, link.end + 1.0, at(next)));
				ids.push_back(next++);
			} else if (!ids.empty()) {
				const size_t index = size_t(random.uniform(0.0, double(ids.size()) - 1e-9));
				CHECK(link.encoder.remove_body(ids[index], link.end + 1.0, k % 2 == 0));
				ids.erase(ids.begin() + ptrdiff_t(index));
			}
		}
		for (int k = 0; k < 3; ++k) {
			const uint32_t id = ids[size_t(random.uniform(0.0, double(ids.size()) - 1e-9))];
			CHECK((k != 1 || link.encoder.jump(id)));
			CHECK(link.encoder.observe(id, link.end + 3.0, at(random.uniform(-50.0, 50.0))));
		}
		StreamDecoder late(0.005f, 1.4f, 100000);
		link.join(late);
		link.window();
		CHECK(link.decoder.body_count() == ids.size());
		// A receiver that joined before the window decodes it, too.
		link.end -= 4.0;
		CHECK(link.decode(late));
		link.end += 4.0;
		CHECK(late.check() == link.decoder.check());
		Bytes snapshots[3];
		link.encoder.encode_snapshot(snapshots[0]);
		link.decoder.encode_snapshot(snapshots[1]);
		late.encode_snapshot(snapshots[2]);
		CHECK(snapshots[0] == snapshots[1]);
		CHECK(snapshots[0] == snapshots[2]);
	}
}

TEST_CASE("body blocks: a window that cannot be decoded changes nothing, whatever it contains") {
	Link link(3 * BLOCK);
	cga_test::Random random(6);
	for (int i = 0; i < 60; ++i) {
		for (int k = 0; k < 4; ++k) {
			const auto id = uint32_t(random.uniform(0.0, 3.0 * BLOCK - 0.001));
			if (!link.encoder.has_body(id)) {
				CHECK(link.encoder.add_body(id, link.end + 1.0, at(id)));
			} else if (k == 0) {
				CHECK(link.encoder.remove_body(id, link.end + 2.0));
			} else {
				CHECK((k == 1 || link.encoder.jump(id)));
				CHECK(link.encoder.observe(id, link.end + 3.0, at(random.uniform(-50.0, 50.0))));
			}
		}
		Bytes before;
		link.decoder.encode_snapshot(before);
		link.bytes.clear();
		link.encoder.encode_window(link.end, 4, link.bytes);
		for (int k = 0; k < 20; ++k) {
			Bytes other = link.bytes;
			other[size_t(random.uniform(0.0, double(other.size()) - 1e-9))] ^= uint8_t(1u << (k % 8));
			StreamDecoder copy = link.decoder;
			if (!copy.decode_window(other.data(), other.size(), { link.encoder.check(), 255 }, link.end, cga::Mode::SEPARATE, link.motions)) {
				Bytes after;
				copy.encode_snapshot(after);
				CHECK(after == before);
				CHECK(link.decode(copy));
			}
		}
		REQUIRE(link.decode(link.decoder));
		link.end += 4.0;
	}
}
