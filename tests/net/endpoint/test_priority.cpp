#include "net/endpoint/sender.hpp"

#include "../simulated_session.hpp"

#include <doctest/doctest.h>

using namespace net;
using namespace net_test;

namespace {

constexpr uint32_t BODIES = 80;
constexpr uint32_t IMPORTANT = 11;

/// Bodies of equal motion at different phases, and a receiver over a line that carries less than they need.
struct NarrowSession : SimulatedSession {
	NarrowSession() {
		for (uint32_t id = 0; id < BODIES; ++id) {
			add_body(id, [id](double time) {
				const double phase = 4.0 * time + double(id);
				return turned_at(Vector3D(std::sin(phase) + 0.3 * std::sin(3.7 * phase), double(id), std::cos(1.3 * phase)), Vector3D(0.6, 0.0, 0.8), 0.7 * phase);
			});
		}
	}

	void connect() { add_receiver(1).down.settings().bytes_per_second = 3000.0; }

	/// The mean error of the other bodies relative to that of the important one, after the line is known.
	double error_ratio() {
		RemoteEnd &end = *ends.at(1);
		run(10.0);
		double important = 0.0;
		double others = 0.0;
		int on_time = 0;
		int steps = 0;
		run(10.0, [&] {
			++steps;
			if (end.receiver->media_time() > end.receiver->known_time()) {
				return; // all bodies wait for motion that is late
			}
			++on_time;
			for (uint32_t id = 0; id < BODIES; ++id) {
				(id == IMPORTANT ? important : others) += error(end, id);
			}
		});
		CHECK(sender->statistics(1).relaxation >= 4.0);
		CHECK(on_time > 0.5 * steps);
		return others / (BODIES - 1) / important;
	}
};

} // namespace

TEST_CASE("priority: over a line that carries less than the motion needs, a body of priority 3 has a much smaller error") {
	NarrowSession session;
	session.connect();
	CHECK(session.error_ratio() < 1.5);
	REQUIRE(session.sender->set_priority(IMPORTANT, 3));
	CHECK(session.error_ratio() > 3.0);
	REQUIRE(session.sender->set_priority(IMPORTANT, 0));
	CHECK(session.error_ratio() < 1.5);
}

TEST_CASE("priority: it is kept while no receiver exists, and when the stream restarts") {
	NarrowSession session;
	REQUIRE(session.sender->set_priority(IMPORTANT, 3));
	session.connect();
	CHECK(session.error_ratio() > 3.0);
	session.sender->remove_receiver(1);
	session.run(1.0);
	session.connect();
	CHECK(session.error_ratio() > 3.0);
	StreamSettings settings = session.sender->settings();
	settings.position_tolerance *= 1.1;
	session.sender->set_settings(settings);
	CHECK(session.error_ratio() > 3.0);
}

TEST_CASE("priority: a body that does not exist has none, and others are clamped to 0 to 8") {
	for (const bool with_receiver : { false, true }) {
		NarrowSession session;
		if (with_receiver) {
			session.connect();
			session.run(0.1);
		}
		CHECK_FALSE(session.sender->set_priority(BODIES, 1));
		CHECK(session.sender->set_priority(IMPORTANT, 300));
		CHECK(session.sender->set_priority(IMPORTANT + 1, -300));
	}
}

TEST_CASE("priority: where a line carries everything, priorities cost nothing") {
	SimulatedSession plain;
	SimulatedSession ranked;
	for (SimulatedSession *session : { &plain, &ranked }) {
		session->keeps_bytes = true;
		add_smooth_bodies(*session, 9);
		for (uint32_t id = 0; session == &ranked && id < 9; ++id) {
			CHECK(session->sender->set_priority(id, int(id)));
		}
		session->add_receiver(1);
		session->run(3.0);
	}
	CHECK(plain.ends.at(1)->bytes_sent == ranked.ends.at(1)->bytes_sent);
}
