#include "../harness/threads.hpp"
#include "motion_scenes.hpp"
#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"
#include "net/pose_codec.hpp"
#include "net/session/session.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

// Each thread has its own objects; with the thread sanitizer, state that they share by mistake fails.

using net_test::turned_at;

static constexpr size_t THREADS = 4;

namespace {

struct Shown {
	std::vector<cga_test::PoseD> poses;
	std::vector<uint64_t> lives;
};

/// Streams the motion of `bodies` bodies, and returns what the receiver shows at the end.
Shown stream(size_t seed, uint32_t bodies) {
	net::Sender sender{ net::StreamSettings() };
	net::Receiver receiver(1000);
	const auto pose = [seed](uint32_t id, double time) { return turned_at({ double(seed + id) + std::sin(time), 0.0, 1.0 }, { 0.0, 1.0, 0.0 }, time); };
	for (uint32_t id = 0; id < bodies; ++id) {
		(void)sender.add_body(id, pose(id, 0.0));
	}
	sender.add_receiver(0, 0.0);
	std::vector<uint8_t> ack;
	for (int tick = 0; tick < 90; ++tick) {
		const double now = tick / 60.0;
		for (uint32_t id = 0; id < bodies; ++id) {
			(void)sender.observe(id, now, pose(id, now));
		}
		sender.flush(now);
		for (const net::OutgoingPacket &packet : sender.packets()) {
			(void)receiver.accept(sender.bytes() + packet.begin, packet.size, now);
		}
		receiver.advance(now);
		receiver.take_ack(ack, now);
		(void)sender.accept(0, ack.data(), ack.size(), now);
	}
	Shown shown;
	for (uint32_t id = 0; id < bodies; ++id) {
		shown.poses.push_back(receiver.pose(id).value_or(cga_test::PoseD()));
		shown.lives.push_back(receiver.life_at_known_end(id));
	}
	return shown;
}

} // namespace

TEST_CASE("threads: each with its own sender and receiver") {
	const std::vector<Shown> results = harness::run_in_threads(THREADS, [](size_t i) { return stream(i, 40); });
	std::set<uint64_t> lives;
	for (size_t i = 0; i < THREADS; ++i) {
		const Shown expected = stream(i, 40);
		for (size_t id = 0; id < 40; ++id) {
			CHECK(results[i].poses[id].translation == expected.poses[id].translation);
			CHECK(results[i].poses[id].rotation == expected.poses[id].rotation);
		}
		lives.insert(results[i].lives.begin(), results[i].lives.end());
	}
	// Lives of one process are all different.
	CHECK(lives.size() == THREADS * 40);
	CHECK(lives.count(0) == 0);
}

TEST_CASE("threads: each with its own codec buffers") {
	const auto work = [](size_t seed) {
		std::vector<net::BodyPose> bodies;
		bodies.reserve(50);
		for (uint32_t id = 0; id < 50; ++id) {
			bodies.push_back({ id, cga::pose_cast<float>(turned_at({ double(seed), double(id), 0.0 }, { 0.0, 1.0, 0.0 }, id)) });
		}
		std::vector<uint8_t> packet;
		(void)net::encode(bodies.data(), bodies.size(), {}, packet);
		std::vector<net::BodyPose> decoded;
		(void)net::decode(packet.data(), packet.size(), decoded);
		packet.push_back(uint8_t(decoded.size()));
		return packet;
	};
	const std::vector<std::vector<uint8_t>> results = harness::run_in_threads(THREADS, work);
	for (size_t i = 0; i < THREADS; ++i) {
		CHECK(results[i] == work(i));
		CHECK(results[i].back() == 50);
	}
}

TEST_CASE("threads: each with its own sessions") {
	// Two sessions that request each other's stream take numbers of the sequence that all sessions share.
	const auto work = [](size_t) {
		size_t packets = 0;
		for (int round = 0; round < 20; ++round) {
			net::Session session{ net::StreamSettings() };
			session.connect(1);
			session.set_peers({ 2, 3 }, double(round));
			session.begin_tick(double(round), 1.0 / 60.0);
			session.end_tick();
			session.advance(double(round));
			session.outbox().drain([&](const net::Outbox::Packet &, const uint8_t *) { ++packets; });
		}
		return packets;
	};
	const size_t expected = work(0);
	for (const size_t packets : harness::run_in_threads(THREADS, work)) {
		CHECK(packets == expected);
	}
	CHECK(expected > 0);
}
