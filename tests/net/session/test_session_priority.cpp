#include "net/session/session.hpp"

#include "session_network.hpp"

#include <doctest/doctest.h>

using namespace net;
using namespace net_test;

namespace {

constexpr uint32_t BODIES = 80;
constexpr uint32_t IMPORTANT = 11;

/// Two peers, the first of which owns bodies of equal motion at different phases, and a line that carries less than they need.
SessionNetwork narrow_network() {
	SessionNetwork network;
	network.join(1);
	network.join(2);
	network.link(1, 2).unreliable.settings().bytes_per_second = 3000.0;
	for (uint32_t body = 0; body < BODIES; ++body) {
		network.paths[body] = [body](double time) {
			const double phase = 4.0 * time + double(body);
			return turned_at(Vector3D(std::sin(phase) + 0.3 * std::sin(3.7 * phase), double(body), std::cos(1.3 * phase)), Vector3D(0.6, 0.0, 0.8), 0.7 * phase);
		};
		network.set_owner(body, 1);
	}
	return network;
}

/// The mean error of the other bodies relative to that of the important one, at peer 2, after the line is known.
double error_ratio(SessionNetwork &network) {
	network.run(10.0);
	double important = 0.0;
	double others = 0.0;
	network.run(10.0, [&] {
		const Receiver *stream = network.session(2).stream(1);
		if (stream == nullptr || stream->media_time() > stream->known_time()) {
			return; // all bodies wait for motion that is late
		}
		for (uint32_t body = 0; body < BODIES; ++body) {
			(body == IMPORTANT ? important : others) += network.error(body, 2);
		}
	});
	CHECK(network.statistics(2, 1).relaxation >= 4.0);
	return others / (BODIES - 1) / important;
}

} // namespace

TEST_CASE("session: the priority of an owned body applies before and while its stream runs, and until its owner changes") {
	SessionNetwork network = narrow_network();
	CHECK_FALSE(network.session(1).is_sending());
	CHECK(network.session(1).set_priority(IMPORTANT, 3));
	CHECK(error_ratio(network) > 3.0);
	CHECK(network.session(1).set_priority(IMPORTANT, 0));
	CHECK(error_ratio(network) < 1.5);
	CHECK(network.session(1).set_priority(IMPORTANT, 3));
	CHECK(error_ratio(network) > 3.0);
	// It becomes a body of another peer and returns, while the stream runs.
	network.set_owner(IMPORTANT, 2);
	CHECK_FALSE(network.session(1).set_priority(IMPORTANT, 3));
	network.run(1.0);
	network.set_owner(IMPORTANT, 1);
	CHECK(error_ratio(network) < 1.5);
}

TEST_CASE("session: the priority of a body that is not in the stream yet applies from its first pose on") {
	SessionNetwork network = narrow_network();
	network.set_owner(IMPORTANT, 2);
	network.run(2.0);
	REQUIRE(network.session(1).is_sending());
	network.set_owner(IMPORTANT, 1);
	CHECK(network.session(1).set_priority(IMPORTANT, 3));
	CHECK(error_ratio(network) > 3.0);
}

TEST_CASE("session: only the priority of owned bodies can be set") {
	SessionNetwork network = network_of_two();
	CHECK(network.session(1).set_priority(5, 1));
	CHECK_FALSE(network.session(2).set_priority(5, 1));
	CHECK_FALSE(network.session(1).set_priority(6, 1));
	Session idle{ StreamSettings() };
	CHECK_FALSE(idle.set_priority(5, 1));
}
