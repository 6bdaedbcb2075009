#include "net/endpoint/receiver.hpp"

#include "../simulated_session.hpp"

#include <doctest/doctest.h>

// The lives of bodies: when they begin and end, as a receiver shows them.

using namespace net;
using namespace net_test;

namespace {

/// A pose on the x axis.
PoseD at(double x) {
	PoseD pose;
	pose.translation.x = x;
	return pose;
}

/// A body that moves along x from `from`, 1 m/s.
Path sliding(double from) {
	return [from](double time) { return at(from + time - 100.0); };
}

/// The life shown; 0 if the body is not shown.
uint64_t life_of(const RemoteEnd &end, uint32_t id) {
	const auto shown = end.receiver->shown(id);
	return shown ? shown->life : 0;
}

} // namespace

TEST_CASE("lives: a body that is removed and added again has another life, also within one window") {
	for (const int gap : { 0, 1, 4, 30, 90 }) { // ticks
		SimulatedSession session;
		session.add_body(1, sliding(0.0));
		session.add_body(2, sliding(0.0)); // keeps windows short
		RemoteEnd &end = session.add_receiver(1);
		session.run(1.0);
		const uint64_t first = life_of(end, 1);
		CAPTURE(gap);
		REQUIRE(first != 0);
		CHECK(life_of(end, 2) != first);
		CHECK(end.receiver->life_at_known_end(1) == first);
		session.bodies.erase(1);
		CHECK(session.sender->remove_body(1));
		const double removed = session.now;
		session.run(gap * SimulatedSession::TICK);
		session.add_body(1, sliding(500.0));
		const double added = session.now;
		uint64_t second = 0;
		bool was_known_ahead = false;
		int mixed = 0; // frames that show a life elsewhere
		int wrong_ends = 0;
		session.run(3.0, [&] {
			const Receiver &receiver = *end.receiver;
			const double media_time = session.origin + receiver.media_time();
			const auto shown = receiver.shown(1);
			const auto next = receiver.first_known(1, first + 1);
			if (shown) {
				mixed += (shown->life == first) != (shown->pose.translation.x < 400.0) ? 1 : 0;
				second = shown->life != first ? shown->life : second;
			}
			was_known_ahead = was_known_ahead || (next && (!shown || shown->life == first));
			if (next) {
				CHECK(next->life > first);
				CHECK(next->pose.translation.x >= 500.0);
				CHECK((second == 0 || next->pose.translation.x == doctest::Approx(shown->pose.translation.x)));
				CHECK(next->pose.translation.x <= 500.0 + std::max(media_time, added) - 100.0 + 0.006);
			}
			const bool is_over = receiver.end(1, first) == BodyEnd::REMOVED;
			wrong_ends += is_over != (media_time >= removed - 1e-6 && media_time <= removed + Receiver::END_MEMORY) && std::abs(media_time - removed) > 1e-6 ? 1 : 0;
			CHECK(receiver.end(2, first) == BodyEnd::NONE); // another body
		});
		CHECK(mixed == 0);
		CHECK(wrong_ends == 0);
		CHECK(second > first);
		CHECK(was_known_ahead);
		CHECK(end.receiver->life_at_known_end(1) == second);
		CHECK(end.receiver->end(1, second) == BodyEnd::NONE);
	}
}

TEST_CASE("lives: a teleport, a change of the settings and a new snapshot do not end a life") {
	SimulatedSession session;
	session.add_body(1, sliding(0.0));
	RemoteEnd &end = session.add_receiver(1);
	session.run(1.0);
	const uint64_t life = life_of(end, 1);
	REQUIRE(life != 0);
	CHECK(session.sender->teleport(1));
	session.bodies[1].path = sliding(100.0);
	session.run(1.0);
	CHECK(life_of(end, 1) == life);
	StreamSettings settings;
	settings.position_tolerance = 0.01;
	session.sender->set_settings(settings);
	session.run(1.0);
	CHECK(life_of(end, 1) == life);
	settings.tick = 1.0 / 30.0; // media time restarts
	session.sender->set_settings(settings);
	session.origin = session.now;
	session.run(2.0);
	CHECK(life_of(end, 1) == life);
	end.change_links([&](LinkSettings &link) {
		link.outage_begin = session.now;
		link.outage_end = session.now + 5.0;
	});
	session.run(8.0);
	CHECK(life_of(end, 1) == life);
	CHECK(end.receiver->end(1, life) == BodyEnd::NONE);
}

TEST_CASE("lives: a removal during an outage ends the life at the snapshot") {
	for (const bool returns : { false, true }) {
		SimulatedSession session;
		session.add_body(1, sliding(0.0));
		session.add_body(2, sliding(0.0));
		RemoteEnd &end = session.add_receiver(1);
		session.run(1.0);
		const uint64_t first = life_of(end, 1);
		end.change_links([&](LinkSettings &link) {
			link.outage_begin = session.now;
			link.outage_end = session.now + 5.0;
		});
		session.run(1.0);
		session.bodies.erase(1);
		CHECK(session.sender->remove_body(1));
		bool has_ended = false;
		session.run(6.0, [&] { has_ended = has_ended || end.receiver->end(1, first) == BodyEnd::REMOVED; });
		CAPTURE(returns);
		CHECK(has_ended);
		CHECK_FALSE(end.receiver->shown(1));
		CHECK(end.receiver->life_at_known_end(1) == 0);
		CHECK_FALSE(end.receiver->first_known(1, 0));
		if (returns) {
			session.add_body(1, sliding(0.0));
			session.run(1.0);
			CHECK(life_of(end, 1) > first);
		}
	}
}

TEST_CASE("lives: a stream's first bodies are known before they are shown, and streams share the numbers") {
	SimulatedSession session;
	session.add_body(1, sliding(0.0));
	RemoteEnd &one = session.add_receiver(1);
	RemoteEnd &other = session.add_receiver(2);
	session.run(1.0);
	CHECK(life_of(one, 1) != 0);
	CHECK(life_of(other, 1) != 0);
	CHECK(life_of(one, 1) != life_of(other, 1));
	CHECK_FALSE(one.receiver->first_known(1, life_of(one, 1) + 1));
	CHECK_FALSE(one.receiver->first_known(9, 0));
	CHECK(one.receiver->life_at_known_end(9) == 0);
	CHECK(one.receiver->end(9, 1) == BodyEnd::NONE);
	const auto known = one.receiver->first_known(1, 0);
	REQUIRE(known);
	CHECK(known->pose.translation.x == one.receiver->pose(1)->translation.x);
	session.add_body(3, sliding(0.0));
	int frames = 0;
	while (!one.receiver->first_known(3, 0) && ++frames < 60) {
		session.step();
	}
	CHECK(frames < 30);
	CHECK_FALSE(one.receiver->pose(3));
}

TEST_CASE("lives: a freed body is shown up to its last pose, and its end says that it was freed") {
	for (const double speed : { 2.0, 40.0 }) {
		for (const bool rests : { false, true }) { // before the last pose
			SimulatedSession session;
			const double impact = 102.0;
			session.add_body(1, [=](double time) { return at(rests ? 0.0 : speed * (time - 100.0)); });
			session.add_body(2, rests ? Path([](double) { return PoseD(); }) : sliding(0.0));
			RemoteEnd &end = session.add_receiver(1);
			while (session.now < impact - 1.5 * SimulatedSession::TICK) {
				session.step();
			}
			const uint64_t life = life_of(end, 1);
			REQUIRE(life != 0);
			// The last pose is observed in the tick in which the body is freed.
			session.now += SimulatedSession::TICK;
			CHECK(session.sender->observe(1, session.now, session.bodies[1].path(session.now)));
			CHECK(session.sender->remove_body(1, true));
			session.bodies.erase(1);
			session.now -= SimulatedSession::TICK;
			double last_x = 0.0;
			double last_shown = 0.0;
			double ended_at = 0.0;
			session.run(1.0, [&] {
				const double media_time = session.origin + end.receiver->media_time();
				if (const auto shown = end.receiver->shown(1)) {
					last_x = shown->pose.translation.x;
					last_shown = media_time;
				}
				ended_at = ended_at == 0.0 && end.receiver->end(1, life) == BodyEnd::FREED ? media_time : ended_at;
			});
			CAPTURE(speed);
			CAPTURE(rests);
			CHECK(last_shown >= impact - 1.7 * SimulatedSession::TICK);
			CHECK(last_x == doctest::Approx(rests ? 0.0 : speed * (last_shown - 100.0)).epsilon(0.001));
			CHECK(ended_at >= impact - 1e-6);
			CHECK(ended_at <= impact + 1.7 * SimulatedSession::TICK);
			CHECK(end.receiver->end(1, life) == BodyEnd::FREED);
		}
	}
}
