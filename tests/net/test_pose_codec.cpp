#include "net/pose_codec.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <string>

using namespace net;

namespace {

using Packet = std::vector<uint8_t>;

std::vector<BodyPose> random_bodies(size_t count, float extent, uint32_t seed) {
	std::mt19937 random(seed);
	std::uniform_real_distribution<float> coordinate(-extent, extent);
	std::normal_distribution<float> normal;
	std::vector<BodyPose> bodies(count);
	for (size_t i = 0; i < count; ++i) {
		bodies[i].id = uint32_t(i);
		bodies[i].pose.translation = glm::vec3(coordinate(random), coordinate(random), coordinate(random));
		bodies[i].pose.rotation = glm::normalize(glm::quat(normal(random), normal(random), normal(random), normal(random)));
	}
	return bodies;
}

double distance(const glm::vec3 &a, const glm::vec3 &b) {
	return std::sqrt(std::pow(double(a.x) - b.x, 2) + std::pow(double(a.y) - b.y, 2) + std::pow(double(a.z) - b.z, 2));
}

std::optional<CodecFault> fault_of(const CodecResult &result) {
	return result ? std::nullopt : std::optional<CodecFault>(result.error().fault);
}

std::optional<CodecFault> encode_fault(const std::vector<BodyPose> &bodies, const Tolerance &tolerance = {}) {
	Packet packet(3, 1);
	const CodecResult result = encode(bodies.data(), bodies.size(), tolerance, packet);
	CHECK(packet.empty() == !result);
	return fault_of(result);
}

std::optional<CodecFault> decode_fault(const Packet &packet) {
	std::vector<BodyPose> bodies(1);
	const CodecResult result = decode(packet.data(), packet.size(), bodies);
	if (!result) {
		CHECK(bodies.empty());
	}
	return fault_of(result);
}

} // namespace

TEST_CASE("pose codec: poses arrive within the tolerance, ids exactly") {
	for (const float position : { 0.0005f, 0.002f, 0.05f }) {
		const Tolerance tolerance{ position, 0.25f };
		const std::vector<BodyPose> sent = random_bodies(500, 20, 3);
		Packet packet;
		REQUIRE(encode(sent.data(), sent.size(), tolerance, packet));
		std::vector<BodyPose> received;
		REQUIRE(decode(packet.data(), packet.size(), received));
		REQUIRE(received.size() == sent.size());
		for (size_t i = 0; i < sent.size(); ++i) {
			CHECK(received[i].id == sent[i].id);
			CHECK(distance(received[i].pose.translation, sent[i].pose.translation) <= double(position) + 4e-6);
			CHECK(std::abs(glm::dot(received[i].pose.rotation, sent[i].pose.rotation)) > std::cos(0.125 * 3.1415927 / 180) - 1e-6);
			CHECK(received[i].pose.scale == 1.0f);
		}
	}
}

TEST_CASE("pose codec: about nine bytes per pose at the default tolerance") {
	const std::vector<BodyPose> bodies = random_bodies(100, 20, 5);
	Packet packet;
	REQUIRE(encode(bodies.data(), bodies.size(), Tolerance{}, packet));
	// 3 * 15 position bits, 2 + 3 * 12 rotor bits, 1 id bit, 1 scale bit = 85 bits; 21 header bytes at most.
	CHECK(packet.size() <= 100 * 85 / 8 + 22);
	CHECK(packet.size() >= 100 * 80 / 8);
}

TEST_CASE("pose codec: ids in any order, with gaps, at the limit") {
	std::vector<BodyPose> bodies(6);
	const uint32_t ids[6] = { 7, 8, 0, 2147483647u, 5, 5 };
	for (int i = 0; i < 6; ++i) {
		bodies[i].id = ids[i];
	}
	Packet packet;
	REQUIRE(encode(bodies.data(), bodies.size(), Tolerance{}, packet));
	std::vector<BodyPose> received;
	REQUIRE(decode(packet.data(), packet.size(), received));
	REQUIRE(received.size() == 6);
	for (int i = 0; i < 6; ++i) {
		CHECK(received[i].id == ids[i]);
	}
}

TEST_CASE("pose codec: scale round-trips, and a scale of 1 costs one bit") {
	std::vector<BodyPose> bodies = random_bodies(64, 5, 9);
	Packet plain;
	REQUIRE(encode(bodies.data(), bodies.size(), Tolerance{}, plain));
	for (size_t i = 0; i < bodies.size(); ++i) {
		bodies[i].pose.scale = 0.01f * std::pow(1.15f, float(i));
	}
	Packet scaled;
	REQUIRE(encode(bodies.data(), bodies.size(), Tolerance{}, scaled));
	CHECK(scaled.size() == plain.size() + 64 * SCALE_BITS / 8);
	std::vector<BodyPose> received;
	REQUIRE(decode(scaled.data(), scaled.size(), received));
	for (size_t i = 0; i < bodies.size(); ++i) {
		CHECK(received[i].pose.scale == doctest::Approx(bodies[i].pose.scale).epsilon(1e-4));
	}
}

TEST_CASE("pose codec: 10 km from the origin the error exceeds the tolerance only by float32 rounding") {
	std::vector<BodyPose> bodies = random_bodies(50, 1, 13);
	for (BodyPose &body : bodies) {
		body.pose.translation += glm::vec3(10000, -10000, 10000);
	}
	Packet packet;
	REQUIRE(encode(bodies.data(), bodies.size(), Tolerance{}, packet));
	CHECK(packet.size() < 50 * 9 + 40); // the offsets are as short as near the origin
	std::vector<BodyPose> received;
	REQUIRE(decode(packet.data(), packet.size(), received));
	for (size_t i = 0; i < bodies.size(); ++i) {
		CHECK(distance(received[i].pose.translation, bodies[i].pose.translation) < 0.002 + 0.001);
	}
}

TEST_CASE("pose codec: a packet without bodies is valid") {
	Packet packet;
	REQUIRE(encode(nullptr, 0, Tolerance{}, packet));
	std::vector<BodyPose> received(4);
	REQUIRE(decode(packet.data(), packet.size(), received));
	CHECK(received.empty());
}

TEST_CASE("pose codec: buffers are reused") {
	const std::vector<BodyPose> bodies = random_bodies(200, 10, 17);
	Packet packet;
	std::vector<BodyPose> received;
	REQUIRE(encode(bodies.data(), bodies.size(), Tolerance{}, packet));
	REQUIRE(decode(packet.data(), packet.size(), received));
	const uint8_t *const bytes = packet.data();
	const BodyPose *const poses = received.data();
	for (int i = 0; i < 10; ++i) {
		REQUIRE(encode(bodies.data(), bodies.size(), Tolerance{}, packet));
		REQUIRE(decode(packet.data(), packet.size(), received));
	}
	CHECK(packet.data() == bytes);
	CHECK(received.data() == poses);
}

TEST_CASE("pose codec: each kind of input that cannot be encoded has its fault") {
	std::vector<BodyPose> bodies = random_bodies(3, 1, 19);
	const std::vector<BodyPose> good = bodies;
	CHECK(encode_fault(good) == std::nullopt);

	bodies[1].pose.translation.y = NAN;
	CHECK(encode_fault(bodies) == CodecFault::POSE_NOT_FINITE);
	bodies = good;
	bodies[2].pose.translation.x = 1e30f;
	CHECK(encode_fault(bodies) == CodecFault::POSITION_TOO_FAR);
	bodies = good;
	bodies[0].pose.rotation = glm::quat(0, 0, 0, 0);
	CHECK(encode_fault(bodies) == CodecFault::ROTATION_NOT_UNIT);
	bodies = good;
	bodies[0].pose.scale = -1;
	CHECK(encode_fault(bodies) == CodecFault::SCALE_OUT_OF_RANGE);
	bodies = good;
	bodies[0].id = ID_LIMIT;
	CHECK(encode_fault(bodies) == CodecFault::ID_OUT_OF_RANGE);
	for (const float bad : { 0.0f, -1.0f, NAN, INFINITY }) {
		CHECK(encode_fault(good, Tolerance{ bad, 1 }) == CodecFault::POSITION_TOLERANCE_OUT_OF_RANGE);
		CHECK(encode_fault(good, Tolerance{ 1, bad }) == CodecFault::ROTATION_TOLERANCE_OUT_OF_RANGE);
	}

	Packet packet;
	bodies = good;
	bodies[2].pose.scale = NAN;
	const CodecResult result = encode(bodies.data(), bodies.size(), Tolerance{}, packet);
	REQUIRE_FALSE(result);
	CHECK(result.error().index == 2);
}

TEST_CASE("pose codec: every truncation and every longer packet is rejected") {
	const std::vector<BodyPose> bodies = random_bodies(12, 4, 23);
	Packet packet;
	REQUIRE(encode(bodies.data(), bodies.size(), Tolerance{}, packet));
	for (size_t size = 0; size < packet.size(); ++size) {
		CAPTURE(size);
		CHECK(decode_fault(Packet(packet.begin(), packet.begin() + ptrdiff_t(size))) != std::nullopt);
	}
	packet.push_back(0);
	CHECK(decode_fault(packet) == CodecFault::TRAILING_BYTES);
	packet[0] = FORMAT_VERSION + 1;
	CHECK(decode_fault(packet) == CodecFault::OTHER_FORMAT_VERSION);
}

TEST_CASE("pose codec: random and mutated packets never give a pose that is not finite") {
	std::mt19937 random(29);
	const std::vector<BodyPose> bodies = random_bodies(20, 4, 31);
	Packet packet;
	REQUIRE(encode(bodies.data(), bodies.size(), Tolerance{}, packet));
	std::vector<BodyPose> received;
	int rejected = 0;
	for (int i = 0; i < 50000; ++i) {
		Packet corrupted = packet;
		if (i % 2 == 0) {
			corrupted.resize(random() % 200);
			for (uint8_t &byte : corrupted) {
				byte = uint8_t(random());
			}
			if (!corrupted.empty()) {
				corrupted[0] = FORMAT_VERSION;
			}
		} else {
			for (int flips = 0; flips < 3; ++flips) {
				corrupted[random() % corrupted.size()] ^= uint8_t(1u << (random() % 8));
			}
		}
		rejected += decode(corrupted.data(), corrupted.size(), received) ? 0 : 1;
		CHECK(received.size() <= corrupted.size() * 8);
		for (const BodyPose &body : received) {
			const bool finite = std::isfinite(body.pose.translation.x) && std::isfinite(body.pose.translation.y) && std::isfinite(body.pose.translation.z) &&
					std::isfinite(body.pose.rotation.w) && std::isfinite(body.pose.scale);
			CHECK(finite);
			CHECK(glm::length(body.pose.rotation) == doctest::Approx(1).epsilon(1e-5));
		}
	}
	CHECK(rejected > 25000);
}

TEST_CASE("pose codec: each fault has a description of its own") {
	std::set<std::string> descriptions;
	for (int fault = 0; fault <= int(CodecFault::TRAILING_BYTES); ++fault) {
		descriptions.insert(describe(CodecFault(fault)));
	}
	CHECK(descriptions.size() == size_t(CodecFault::TRAILING_BYTES) + 1);
	CHECK(descriptions.count("unknown error") == 0);
}
