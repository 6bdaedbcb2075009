#include "net/endpoint/receiver_budget.hpp"

#include "../simulated_session.hpp"

#include <doctest/doctest.h>

using namespace net;
using namespace net_test;

TEST_CASE("work budget: time refills it up to its capacity, also after it was overdrawn") {
	WorkBudget budget(10.0, 3.0);
	budget.refill(100.0);
	CHECK_FALSE(budget.is_spent());
	budget.spend(50.0);
	CHECK(budget.is_spent());
	budget.refill(101.9);
	CHECK(budget.is_spent());
	budget.refill(102.1);
	CHECK_FALSE(budget.is_spent());
	budget.refill(1000.0);
	budget.spend(29.9);
	CHECK_FALSE(budget.is_spent());
	budget.spend(0.2);
	CHECK(budget.is_spent());
	// A clock that goes back refills nothing, and continues from there.
	budget.refill(5.0);
	CHECK(budget.is_spent());
	budget.refill(5.1);
	CHECK_FALSE(budget.is_spent());
}

TEST_CASE("receiver budget: a stream is exceeded by waiting without a break, not by a receiver that stood still") {
	ReceiverBudget budget(nullptr);
	double now = 0.0;
	for (int i = 0; i < 200; ++i) {
		now += 0.1;
		budget.note_waiting(i % 20 != 19, now);
		CHECK_FALSE(budget.is_exceeded());
	}
	budget.note_waiting(true, now);
	now += 60.0;
	budget.note_waiting(true, now);
	CHECK_FALSE(budget.is_exceeded());
	for (double waited = 0.25; waited < ReceiverBudget::MAX_WAIT + 0.2; waited += 0.1) {
		now += 0.1;
		budget.note_waiting(true, now);
	}
	CHECK(budget.is_exceeded());
	budget.refuse(now);
	CHECK_FALSE(budget.is_exceeded());
}

TEST_CASE("receiver budget: 40,000 bodies that move cost at most two thirds of it, and ordinary streams never wait") {
	constexpr uint32_t COUNT = 1000;
	SimulatedSession session;
	const std::vector<Motion> all = motions(Vector3D(0.0));
	for (uint32_t id = 0; id < COUNT; ++id) {
		const Path path = all[id % all.size()].path;
		session.add_body(id, [path, id](double time) { return path(time - 100.0 + 0.01 * id); });
	}
	RemoteEnd &end = session.add_receiver(1);
	session.run(1.0);
	const ReceiverBudget &budget = end.receiver->budget();
	const double before = budget.total_work();
	int waiting = 0;
	session.run(2.0, [&] { waiting += budget.is_waiting() ? 1 : 0; });
	CHECK(waiting == 0);
	CHECK(session.packets_rejected == 0);
	const double work = (budget.total_work() - before) / 2.0;
	CHECK(work > 5.0 * COUNT); // windows per second
	CHECK(work / COUNT * 40000.0 < 0.67 * ReceiverBudget::work_rate(40000));
}

TEST_CASE("receiver budget: a receiver that stood still for a minute catches up") {
	StreamSettings settings;
	Sender sender(settings);
	Receiver receiver;
	for (uint32_t id = 0; id < 300; ++id) {
		REQUIRE(sender.add_body(id, PoseD()));
	}
	sender.add_receiver(1, 0.0);
	std::vector<std::vector<uint8_t>> packets; // on the way
	std::vector<uint8_t> ack;
	int rejected = 0;
	for (int tick = 1; tick < 90 * 60; ++tick) {
		const double now = tick / 60.0;
		for (uint32_t id = 0; id < 300; ++id) {
			PoseD pose;
			pose.translation = Vector3D(std::sin(now + id), 2.0 * std::cos(1.3 * now), double(id));
			(void)sender.observe(id, now, pose);
		}
		sender.flush(now);
		for (const OutgoingPacket &packet : sender.packets()) {
			packets.emplace_back(sender.bytes() + packet.begin, sender.bytes() + packet.begin + packet.size);
		}
		if (now > 10.0 && now < 70.0) {
			continue;
		}
		for (const std::vector<uint8_t> &packet : packets) {
			rejected += receiver.accept(packet.data(), packet.size(), now) ? 0 : 1;
		}
		packets.clear();
		receiver.advance(now);
		receiver.take_ack(ack, now);
		if (!ack.empty()) {
			REQUIRE(sender.accept(1, ack.data(), ack.size(), now));
		}
	}
	CHECK(rejected == 0);
	CHECK_FALSE(receiver.is_refused());
	CHECK(receiver.known_time() > 89.0);
	CHECK(receiver.media_time() > 89.0);
}
