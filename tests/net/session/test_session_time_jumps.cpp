#include "session_network.hpp"

#include <limits>

using namespace net;
using namespace net_test;

TEST_CASE("session: jumps of the server's or the client's clock do not stop a stream, with and without relaying") {
	for (const bool relay : { false, true }) {
		for (const PeerId jumper : { 1, 2 }) {
			for (const double jump : { 3.0, 86400.0, 1e9, 9e11, -3.0, -86400.0, -1e9, -9e11 }) {
				CAPTURE(relay);
				CAPTURE(jumper);
				CAPTURE(jump);
				SessionNetwork network;
				for (const PeerId peer : { 1, 2, 3 }) {
					network.join(peer);
					network.session(peer).set_relay(relay);
				}
				network.paths[5] = [](double t) {
					PoseD pose;
					pose.translation.x = t;
					return pose;
				};
				network.set_owner(5, 2);
				network.run(3.0);
				network.clock_jumps[jumper] += jump;
				network.run(4.0);
				// A peer that joins after the jump.
				network.join(4);
				network.session(4).set_relay(relay);
				network.run(3.0);
				for (const PeerId peer : { 1, 3, 4 }) {
					CAPTURE(peer);
					const Receiver *stream = network.session(peer).stream(2);
					REQUIRE(stream != nullptr);
					const auto pose = stream->pose(5);
					REQUIRE(pose);
					CHECK(pose->translation.x > network.now - 0.6);
					CHECK(pose->translation.x < network.now);
				}
			}
		}
	}
}

TEST_CASE("session: invalid times and tick lengths are ignored") {
	SessionNetwork network;
	network.join(1);
	network.join(2);
	network.paths[5] = [](double t) {
		PoseD pose;
		pose.translation.x = t;
		return pose;
	};
	network.set_owner(5, 1);
	network.run(3.0);
	for (const double invalid : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e18, 1e308, -1.0, 0.0 }) {
		for (const PeerId id : { 1, 2 }) {
			Session &session = network.session(id);
			session.begin_tick(network.local(id), invalid);
			session.end_tick();
			if (!is_valid_time(invalid)) {
				session.begin_tick(invalid, network.tick);
				session.end_tick();
				session.advance(invalid);
				(void)session.statistics(3 - id, invalid);
				(void)session.total_statistics(invalid);
				const uint8_t byte = 0;
				session.accept(3 - id, &byte, 1, invalid);
			}
		}
		network.run(0.1);
	}
	network.run(3.0);
	const auto pose = network.session(2).stream(1)->pose(5);
	REQUIRE(pose);
	CHECK(network.session(2).stream(1)->settings().tick == network.tick);
	CHECK(pose->translation.x > network.now - 0.6);
}
