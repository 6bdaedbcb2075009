#include "net/endpoint/receiver.hpp"

#include "../../harness/allocation_counter.hpp"
#include "../simulated_session.hpp"

#include <doctest/doctest.h>

using namespace net;
using namespace net_test;

TEST_CASE("receiver: over an unimpaired link every pose shown is within the tolerance") {
	for (const cga::Mode mode : { cga::Mode::SEPARATE, cga::Mode::LINEAR, cga::Mode::SCREW }) {
		StreamSettings settings;
		settings.mode = mode;
		SimulatedSession session(settings);
		add_smooth_bodies(session, 20);
		RemoteEnd &end = session.add_receiver(1);
		session.run(1.0);
		double worst = 0.0;
		session.run(5.0, [&] { worst = std::max(worst, session.error(end)); });
		CAPTURE(int(mode));
		CHECK(worst <= 1.3); // the bound holds at samples; this measures between them too
		CHECK(end.steps_back == 0);
		CHECK(end.receiver->statistics().late_windows == 0);
		CHECK(end.receiver->statistics().playback_delay <= settings.max_latency + 0.02);
		CHECK(end.receiver->statistics().round_trip == doctest::Approx(0.06).epsilon(0.5));
		CHECK(end.receiver->known_time() > end.receiver->media_time());
	}
}

TEST_CASE("receiver: over any link, media time never runs backwards and playback ends at the sender's poses") {
	struct Row {
		std::string name;
		LinkSettings link;
	};
	for (const Row &row : {
				 Row{ "jitter", { 0.03, 0.1 } },
				 Row{ "5 %", { 0.03, 0.03, 0.05 } },
				 Row{ "30 %", { 0.05, 0.1, 0.3, 0.1 } },
				 Row{ "50 %", { 0.03, 0.02, 0.5 } },
				 Row{ "duplicates", { 0.01, 0.2, 0.0, 1.0 } },
				 Row{ "outage", { 0.03, 0.0, 0.02, 0.0, 103.0, 104.0 } },
		 }) {
		SimulatedSession session;
		add_smooth_bodies(session, 12);
		RemoteEnd &one = session.add_receiver(1, row.link);
		RemoteEnd &other = session.add_receiver(2);
		session.run(8.0);
		CAPTURE(row.name);
		CHECK(one.ready_at > 0.0);
		CHECK(one.steps_back == 0);
		CHECK(one.not_finite == 0);
		// Losses of one receiver do not affect the other.
		double worst = 0.0;
		session.run(2.0, [&] { worst = std::max(worst, session.error(other)); });
		CHECK(worst <= 1.3);
		CHECK(other.receiver->statistics().late_windows <= 1);
		// All bodies stop; the link does not change.
		for (auto &body : session.bodies) {
			const PoseD last = body.second.path(session.now);
			body.second.path = [last](double) { return last; };
		}
		session.run(6.0);
		CHECK(session.error(one) <= 1.02);
		CHECK(session.error(other) <= 1.02);
		CHECK(session.packets_rejected == 0);
		CHECK(session.acks_rejected == 0);
		CHECK(one.largest_packet <= StreamSettings().max_packet_size);
	}
}

TEST_CASE("receiver: 250 ms after the last lost packet the error is below the bound again") {
	for (unsigned seed = 1; seed <= 5; ++seed) {
		SimulatedSession session;
		add_smooth_bodies(session, 12);
		RemoteEnd &end = session.add_receiver(seed, { 0.04, 0.03, 0.3, 0.05 });
		session.run(10.0);
		end.change_links([](LinkSettings &link) { link.loss = 0.0; });
		const double last_loss = std::max(end.down.model().last_loss_time(), end.up.model().last_loss_time());
		double back_at = last_loss;
		session.run(3.0, [&] { back_at = session.error(end) > 1.3 ? session.now : back_at; });
		CAPTURE(seed);
		CHECK(back_at - last_loss <= 0.25 + SimulatedSession::TICK);
		CHECK(end.steps_back == 0);
	}
}

TEST_CASE("receiver: a teleport is never interpolated, over any link") {
	for (const double loss : { 0.0, 0.2 }) {
		SimulatedSession session;
		const double jump_time = 103.0;
		session.add_body(1, [=](double t) {
			PoseD pose;
			pose.translation = Vector3D(t < jump_time - 1e-6 ? t - 100.0 : 500.0 + t - 100.0, 0.0, 0.0);
			return pose;
		});
		RemoteEnd &end = session.add_receiver(1, { 0.03, 0.05, loss, 0.1 });
		int between = 0;
		int returned = 0;
		int too_soon = 0;
		bool is_there = false;
		session.run(2.0);
		session.run(4.0, [&] {
			if (session.now < jump_time - 1e-6 && session.now + SimulatedSession::TICK >= jump_time - 1e-6) {
				CHECK(session.sender->teleport(1));
			}
			const std::optional<PoseD> pose = end.receiver->pose(1);
			if (!pose) {
				return;
			}
			const double x = pose->translation.x;
			between += x > 10.0 && x < 500.0 ? 1 : 0;
			returned += is_there && x < 10.0 ? 1 : 0;
			is_there = is_there || x >= 500.0;
			too_soon += x >= 500.0 && session.origin + end.receiver->media_time() < jump_time - 1e-6 ? 1 : 0;
		});
		CAPTURE(loss);
		CHECK(is_there);
		CHECK(between == 0);
		CHECK(returned == 0);
		CHECK(too_soon == 0);
	}
}

TEST_CASE("receiver: bodies are added and removed, with events in order") {
	SimulatedSession session;
	session.takes_events = false;
	const Path rest = [](double) { return PoseD(); };
	session.add_body(1, rest);
	RemoteEnd &end = session.add_receiver(1, { 0.03, 0.01 });
	session.run(1.0);
	std::vector<BodyEvent> events;
	end.receiver->take_events(events);
	REQUIRE(events.size() == 1);
	CHECK(events[0].kind == BodyEvent::ADDED);
	CHECK(events[0].id == 1);
	session.add_body(2, rest);
	session.run(0.02);
	session.bodies.erase(1);
	CHECK(session.sender->remove_body(1));
	session.run(1.0);
	end.receiver->take_events(events);
	REQUIRE(events.size() == 2);
	CHECK(events[0].kind == BodyEvent::ADDED);
	CHECK(events[0].id == 2);
	CHECK(events[1].kind == BodyEvent::REMOVED);
	CHECK(events[1].id == 1);
	CHECK(end.receiver->bodies() == std::vector<uint32_t>{ 2 });
	CHECK_FALSE(end.receiver->pose(1));
	CHECK(end.receiver->pose(2));
	end.receiver->take_events(events);
	CHECK(events.empty());
}

TEST_CASE("receiver: memory does not grow for a minute at 30 % loss, and is released") {
	const size_t initial = harness::live_bytes();
	{
		SimulatedSession session;
		add_smooth_bodies(session, 10);
		session.add_receiver(1, { 0.05, 0.1, 0.3, 0.1 });
		session.run(30.0);
		const size_t before = harness::live_bytes();
		size_t max_bytes = 0;
		session.run(60.0, [&] { max_bytes = std::max(max_bytes, harness::live_bytes()); });
		CHECK(max_bytes < before + 200000);
		CHECK(session.error(*session.ends[1]) < 1e6);
	}
	CHECK(harness::live_bytes() <= initial + 1000);
}

TEST_CASE("receiver: random packets are rejected or recovered from, and memory is bounded") {
	SimulatedSession session;
	add_smooth_bodies(session, 5);
	RemoteEnd &end = session.add_receiver(1);
	session.run(2.0);
	cga_test::Random random(81);
	const size_t before = harness::live_bytes();
	int rejected = 0;
	for (int i = 0; i < 20000; ++i) {
		std::vector<uint8_t> packet(size_t(random.uniform(0.0, i % 10 == 0 ? 1400.0 : 60.0)));
		for (uint8_t &byte : packet) {
			byte = uint8_t(random.uniform(0.0, 256.0));
		}
		if (!packet.empty() && i % 2 == 0) {
			const uint8_t kinds[] = { 0x80, 0x90, 0x60, 0x6f, 0xc0, 0xc2 };
			packet[0] = kinds[i / 2 % 6];
		}
		rejected += end.receiver->accept(packet.data(), packet.size(), session.now + 5000.0) ? 0 : 1;
		CHECK(cga_test::is_finite(end.receiver->pose(0).value_or(PoseD())));
	}
	CHECK(rejected > 5000);
	CHECK(rejected < 20000);
	CHECK(end.receiver->statistics().packets_rejected == uint64_t(rejected));
	CHECK(harness::live_bytes() < before + 4000000);
	// It recovers.
	session.run(8.0);
	CHECK(session.error(end) <= 1.3);
}

TEST_CASE("receiver: a stream with more than max_bodies bodies is rejected") {
	SimulatedSession session;
	add_smooth_bodies(session, 60);
	RemoteEnd &end = session.add_receiver(1);
	end.receiver = std::make_unique<Receiver>(50);
	session.run(1.0);
	CHECK_FALSE(end.receiver->is_ready());
	CHECK(end.receiver->statistics().packets_rejected > 0);
}
