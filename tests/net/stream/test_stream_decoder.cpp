#include "net/stream/stream_decoder.hpp"

#include "../../harness/allocation_counter.hpp"
#include "../stream_scene.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace net;
using namespace net_test;

namespace {

using Bytes = std::vector<uint8_t>;

struct Window {
	Bytes bytes;
	uint8_t check = 0;
	double begin = 0.0;
	int ticks = 0;
};

/// A scene's stream: a snapshot and the windows after it.
struct Recording {
	Bytes snapshot;
	std::vector<Window> windows;

	Recording(unsigned seed, int count, int first = 20) {
		StreamEncoder encoder(0.005f, 1.4f, cga::Mode::SEPARATE);
		StreamScene scene(encoder, seed);
		double tick = 0.0;
		for (int i = 0; i < count + first; ++i) {
			Window window;
			window.begin = tick;
			window.ticks = 3 + i % 9;
			for (int k = 0; k < window.ticks; ++k) {
				scene.step(++tick, 0.08);
			}
			encoder.encode_window(window.begin, window.ticks, window.bytes);
			window.check = encoder.check();
			scene.end_window();
			if (i == first - 1) {
				encoder.encode_snapshot(snapshot);
			} else if (i >= first) {
				windows.push_back(window);
			}
		}
	}
};

bool decode(StreamDecoder &decoder, const Bytes &bytes, uint8_t check, double begin, std::vector<BodyMotion> &motions) {
	return decoder.decode_window(bytes.data(), bytes.size(), { check, 255 }, begin, cga::Mode::SEPARATE, motions).has_value();
}

std::vector<PoseD> poses(const StreamDecoder &decoder) {
	std::vector<PoseD> all;
	all.reserve(decoder.body_count());
	for (size_t i = 0; i < decoder.body_count(); ++i) {
		all.push_back(decoder.pose(i));
	}
	return all;
}

bool is_same(const std::vector<PoseD> &a, const std::vector<PoseD> &b) {
	return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const PoseD &p, const PoseD &q) { return p.translation == q.translation && p.rotation == q.rotation && p.scale == q.scale; });
}

/// The bytes with small changes, truncated, extended or replaced by noise.
Bytes corrupted(const Bytes &bytes, std::mt19937 &random) {
	Bytes other = bytes;
	switch (random() % 4) {
		case 0:
			other.resize(random() % (other.size() + 1));
			break;
		case 1:
			other.resize(random() % 120);
			for (uint8_t &byte : other) {
				byte = uint8_t(random());
			}
			break;
		case 2:
			other.insert(other.end(), 1 + random() % 30, uint8_t(random()));
			break;
		default:
			for (size_t flips = 1 + random() % 4; flips > 0 && !other.empty(); --flips) {
				other[random() % other.size()] ^= uint8_t(1u << (random() % 8));
			}
	}
	return other;
}

} // namespace

TEST_CASE("stream decoder: corrupted windows are rejected without a change, except those that the checksum does not detect") {
	const Recording recording(71, 60);
	std::mt19937 random(1);
	StreamDecoder decoder(0.005f, 1.4f, 100);
	REQUIRE(decoder.read_snapshot(recording.snapshot.data(), recording.snapshot.size()));
	std::vector<BodyMotion> motions;
	int tried = 0;
	int accepted = 0;
	for (const Window &window : recording.windows) {
		const std::vector<PoseD> before = poses(decoder);
		for (int i = 0; i < 60; ++i) {
			const Bytes bytes = corrupted(window.bytes, random);
			const bool is_whole = bytes == window.bytes;
			StreamDecoder copy = decoder;
			++tried;
			if (decode(copy, bytes, window.check, window.begin, motions)) {
				accepted += is_whole ? 0 : 1;
				CHECK(copy.body_count() <= 100);
				for (const BodyMotion &motion : motions) {
					CHECK(cga_test::is_finite(motion.segment.pose_at(motion.segment.begin + 0.5)));
				}
			} else {
				CHECK(motions.empty());
				CHECK(is_same(poses(copy), before));
				CHECK(decode(copy, window.bytes, window.check, window.begin, motions)); // the decoder continues with the intact window
			}
		}
		REQUIRE(decode(decoder, window.bytes, window.check, window.begin, motions));
	}
	CHECK(accepted < tried * 5 / 16); // a quarter are extended: bytes after a window's end change nothing
}

TEST_CASE("stream decoder: a wrong checksum is rejected, as is a window out of order") {
	const Recording recording(72, 30);
	StreamDecoder decoder(0.005f, 1.4f, 100);
	REQUIRE(decoder.read_snapshot(recording.snapshot.data(), recording.snapshot.size()));
	std::vector<BodyMotion> motions;
	int wrong_order = 0;
	for (size_t i = 0; i + 1 < recording.windows.size(); ++i) {
		const Window &window = recording.windows[i];
		for (int check = 0; check < 16; ++check) {
			StreamDecoder copy = decoder;
			CHECK(decode(copy, window.bytes, uint8_t(check), window.begin, motions) == (check == window.check));
		}
		StreamDecoder copy = decoder;
		wrong_order += decode(copy, recording.windows[i + 1].bytes, recording.windows[i + 1].check, window.begin, motions);
		REQUIRE(decode(decoder, window.bytes, window.check, window.begin, motions));
	}
	CHECK(wrong_order < 6);
}

TEST_CASE("stream decoder: corrupted snapshots are rejected without a change, or contain bodies with valid poses") {
	const Recording recording(73, 20);
	const Recording other(74, 1);
	std::mt19937 random(2);
	std::vector<BodyMotion> motions;
	int rejected = 0;
	for (int i = 0; i < 2000; ++i) {
		StreamDecoder decoder(0.005f, 1.4f, 30);
		REQUIRE(decoder.read_snapshot(other.snapshot.data(), other.snapshot.size()));
		const std::vector<PoseD> before = poses(decoder);
		const Bytes bytes = corrupted(recording.snapshot, random);
		if (!decoder.read_snapshot(bytes.data(), bytes.size())) {
			++rejected;
			CHECK(is_same(poses(decoder), before));
			continue;
		}
		CHECK(decoder.body_count() <= 30);
		for (const PoseD &pose : poses(decoder)) {
			CHECK(cga_test::is_finite(pose));
			CHECK(pose.scale > 0.0);
			CHECK(glm::length(pose.rotation) == doctest::Approx(1.0).epsilon(1e-12));
		}
		for (const Window &window : recording.windows) {
			for (int check = 0; check < 16; ++check) {
				if (decode(decoder, window.bytes, uint8_t(check), window.begin, motions)) {
					for (const BodyMotion &motion : motions) {
						CHECK(cga_test::is_finite(motion.segment.pose_at(motion.segment.begin + 0.5)));
					}
					break;
				}
			}
		}
	}
	CHECK(rejected > 200);
}

TEST_CASE("stream decoder: no input makes it exceed its maximum number of bodies or allocate memory for more") {
	StreamEncoder encoder(0.005f, 1.4f, cga::Mode::SEPARATE);
	for (uint32_t id = 0; id < 50; ++id) {
		REQUIRE(encoder.add_body(id, 0.0, PoseD()));
	}
	Bytes empty_snapshot;
	encoder.encode_snapshot(empty_snapshot);
	Bytes window;
	encoder.encode_window(0.0, 1, window);
	Bytes snapshot;
	encoder.encode_snapshot(snapshot);
	std::vector<BodyMotion> motions;
	for (const size_t max_bodies : { size_t(49), size_t(50) }) {
		StreamDecoder decoder(0.005f, 1.4f, max_bodies);
		const PacketResult result = decoder.read_snapshot(snapshot.data(), snapshot.size());
		CHECK(result.has_value() == (max_bodies == 50));
		CHECK((result || result.error() == PacketError::TOO_MANY_BODIES));
		REQUIRE(decoder.read_snapshot(empty_snapshot.data(), empty_snapshot.size()));
		CHECK(decode(decoder, window, encoder.check(), 0.0, motions) == (max_bodies == 50));
	}
	// A number of bodies that exceeds the number of bytes.
	Bytes false_count;
	RangeEncoder coder(false_count);
	uint32_t number = 12;
	coder.bits(number, 7);
	coder.bits(number, 32);
	MotionModels models;
	code_models(coder, models);
	number = 1000000;
	coder.bits(number, INDEX_BITS);
	coder.finish();
	StreamDecoder decoder(0.005f, 1.4f, 2000000);
	const size_t before = harness::live_bytes();
	const PacketResult result = decoder.read_snapshot(false_count.data(), false_count.size());
	REQUIRE_FALSE(result);
	CHECK(result.error() == PacketError::UNREADABLE_SNAPSHOT);
	std::mt19937 random(4);
	for (int i = 0; i < 300; ++i) {
		Bytes bytes(1300);
		for (uint8_t &byte : bytes) {
			byte = uint8_t(random());
		}
		(void)decode(decoder, bytes, uint8_t(i % 16), 0.0, motions);
	}
	CHECK(harness::live_bytes() < before + 3000000);
}

TEST_CASE("stream: encoder and decoder do not allocate in steady state") {
	StreamEncoder encoder(0.005f, 1.4f, cga::Mode::SEPARATE);
	StreamDecoder decoder(0.005f, 1.4f, 1000);
	const std::vector<Motion> all = motions(Vector3D(0.0));
	for (uint32_t id = 0; id < 130; ++id) {
		REQUIRE(encoder.add_body(id, 0.0, all[id % all.size()].path(0.0)));
	}
	Bytes bytes;
	encoder.encode_snapshot(bytes);
	REQUIRE(decoder.read_snapshot(bytes.data(), bytes.size()));
	std::vector<BodyMotion> shown;
	size_t before = 0;
	for (int window = 0; window < 60; ++window) {
		if (window == 30) {
			before = harness::allocation_count();
		}
		for (int tick = 1; tick <= 12; ++tick) {
			const double time = window * 12.0 + tick;
			for (uint32_t id = 0; id < 130; ++id) {
				(void)encoder.observe(id, time, all[id % all.size()].path(time / 60.0));
			}
		}
		bytes.clear();
		encoder.encode_window(window * 12.0, 12, bytes);
		const bool read = decode(decoder, bytes, encoder.check(), window * 12.0, shown);
		if (!read) {
			FAIL("the decoder lost the stream");
		}
	}
	CHECK(harness::allocation_count() == before);
}

TEST_CASE("stream decoder: its snapshots are those of the encoder") {
	StreamEncoder encoder(0.005f, 1.4f, cga::Mode::SEPARATE);
	StreamScene scene(encoder, 5);
	StreamDecoder decoder(0.005f, 1.4f, 100);
	std::vector<BodyMotion> motions;
	double tick = 0.0;
	for (int i = 0; i < 60; ++i) {
		Bytes snapshot;
		encoder.encode_snapshot(snapshot);
		if (i == 20) {
			REQUIRE(decoder.read_snapshot(snapshot.data(), snapshot.size()));
		}
		if (i >= 20) {
			Bytes decoded;
			decoder.encode_snapshot(decoded);
			CHECK(decoded == snapshot);
		}
		const double begin = tick;
		for (int k = 0; k < 3 + i % 9; ++k) {
			scene.step(++tick, 0.08);
		}
		Bytes window;
		encoder.encode_window(begin, int(tick - begin), window);
		scene.end_window();
		if (i >= 20) {
			REQUIRE(decode(decoder, window, encoder.check(), begin, motions));
			CHECK(decoder.check() == encoder.check());
		}
	}
}

TEST_CASE("stream decoder: a jump cannot make a body planar, or a planar body not planar") {
	struct Output {
		Bytes snapshot;
		Bytes window; // in which the body jumps
	};
	const auto encoded = [](bool planar) {
		StreamEncoder encoder(0.005f, 1.4f, cga::Mode::SEPARATE);
		REQUIRE(encoder.add_body(1, 0.0, PoseD(), planar));
		Output output;
		encoder.encode_window(0.0, 1, output.window);
		encoder.encode_snapshot(output.snapshot);
		REQUIRE(encoder.jump(1));
		REQUIRE(encoder.observe(1, 2.0, PoseD()));
		output.window.clear();
		encoder.encode_window(1.0, 1, output.window);
		return output;
	};
	const Output outputs[2] = { encoded(false), encoded(true) };
	std::vector<BodyMotion> motions;
	for (const Output &from : outputs) {
		for (const Output &to : outputs) {
			StreamDecoder decoder(0.005f, 1.4f, 10);
			REQUIRE(decoder.read_snapshot(from.snapshot.data(), from.snapshot.size()));
			const auto ticks = decoder.decode_window(to.window.data(), to.window.size(), { 0, 0 }, 1.0, cga::Mode::SEPARATE, motions);
			CHECK(ticks.has_value() == (&from == &to));
		}
	}
}
