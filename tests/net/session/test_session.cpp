#include "net/session/session.hpp"

#include "session_network.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

using namespace net;
using namespace net_test;

TEST_CASE("session: poses of several peers arrive at all others within the tolerance") {
	SessionNetwork network({ 0.03, 0.01 });
	for (PeerId id = 1; id <= 4; ++id) {
		network.join(id);
	}
	for (uint32_t body = 0; body < 12; ++body) {
		network.paths[body] = smooth_path(body);
		network.set_owner(body, PeerId(body % 3 + 1)); // peer 4 only receives
	}
	network.run(2.0);
	double worst = 0.0;
	network.run(4.0, [&] {
		for (PeerId at = 1; at <= 4; ++at) {
			for (uint32_t body = 0; body < 12; ++body) {
				worst = PeerId(body % 3 + 1) == at ? worst : std::max(worst, network.error(body, at));
			}
		}
	});
	CHECK(worst <= 1.3);
	CHECK_FALSE(network.session(4).is_sending());
	for (PeerId at = 1; at <= 4; ++at) {
		CHECK(network.total(at).rejected == 0);
		CHECK(network.total(at).unauthorized == 0);
		CHECK(network.peers[at].poses_rejected == 0);
		CHECK(network.peers[at].reports.empty());
	}
}

TEST_CASE("session: planar bodies among others, with every owner") {
	SessionNetwork network;
	network.has_planar_bodies = true;
	for (PeerId id = 1; id <= 3; ++id) {
		network.join(id);
	}
	for (uint32_t body = 0; body < 4; ++body) {
		const Path path = smooth_path(body);
		network.paths[body] = body % 2 == 0 ? path : [path](double time) {
			PoseD pose = BodyState::planar_part(path(time));
			pose.rotation = glm::normalize(pose.rotation);
			return pose;
		};
	}
	for (const PeerId owner : { 1, 2 }) {
		for (uint32_t body = 0; body < 4; ++body) {
			network.set_owner(body, owner);
		}
		network.run(2.0);
		double worst = 0.0;
		network.run(2.0, [&] {
			for (uint32_t body = 0; body < 4; ++body) {
				worst = std::max(worst, network.error(body, 3));
				const PoseD shown = network.session(3).stream(owner)->pose(body).value_or(PoseD());
				CHECK((body % 2 == 0 || shown.translation.z == 0.0));
			}
		});
		CHECK(worst <= 1.3);
		CHECK(network.peers[owner].poses_rejected == 0);
	}
}

TEST_CASE("session: over impaired links all peers end at the owner's poses") {
	for (const LinkSettings &link : { LinkSettings{ 0.03, 0.1, 0.3, 0.1 }, LinkSettings{ 0.05, 0.02, 0.5 }, LinkSettings{ 0.01, 0.2, 0.0, 1.0 } }) {
		SessionNetwork network(link);
		for (PeerId id = 1; id <= 3; ++id) {
			network.join(id);
		}
		for (uint32_t body = 0; body < 6; ++body) {
			const Path path = smooth_path(body);
			network.paths[body] = [path](double time) { return path(std::min(time, 108.0)); };
			network.set_owner(body, PeerId(body % 3 + 1));
		}
		network.run(14.0);
		CAPTURE(link.loss);
		for (PeerId at = 1; at <= 3; ++at) {
			for (uint32_t body = 0; body < 6; ++body) {
				CHECK((PeerId(body % 3 + 1) == at || network.error(body, at) <= 1.02));
			}
			CHECK(network.total(at).rejected == 0);
		}
	}
}

TEST_CASE("session: a pose that is not finite or out of range is rejected, and peers keep the last one") {
	SessionNetwork network = network_of_two();
	network.run(2.0);
	for (const double bad : { std::numeric_limits<double>::quiet_NaN(), 1e300 }) {
		network.paths[5] = smooth_path(5);
		network.run(1.0);
		const PoseD last = network.paths[5](network.now);
		network.peers[1].poses_rejected = 0;
		network.paths[5] = [bad](double) { return turned_at(Vector3D(bad), Vector3D(1.0, 0.0, 0.0), 0.0); };
		network.run(1.0);
		CHECK(network.peers[1].poses_rejected == 60);
		const std::optional<PoseD> shown = network.session(2).stream(1)->pose(5);
		REQUIRE(shown);
		CHECK(glm::length(shown->translation - last.translation) < 0.01);
		network.paths[5] = smooth_path(5);
		network.run(1.0);
		CHECK(network.error(5, 2) <= 1.3);
	}
	// A body whose first pose is invalid is not shown.
	network.paths[6] = [](double) { return turned_at(Vector3D(1e300), Vector3D(1.0, 0.0, 0.0), 0.0); };
	network.set_owner(6, 1);
	network.run(1.0);
	CHECK_FALSE(network.session(2).stream(1)->pose(6));
	CHECK_FALSE(network.session(1).observe(6));
	CHECK_FALSE(network.session(2).observe(5, PoseD())); // sends nothing
	CHECK(network.error(5, 2) <= 1.3);
}

TEST_CASE("session: a body that is reported unchanged stays at its last pose") {
	SessionNetwork network;
	Session &owner = network.join(1);
	network.join(2);
	network.set_owner(5, 1);
	const PoseD pose = turned_at(Vector3D(1.0, 2.0, 3.0), Vector3D(0.0, 1.0, 0.0), 0.5);
	CHECK_FALSE(owner.observe(5, pose)); // no peer receives it yet
	network.run(0.2);
	REQUIRE(owner.is_sending());
	CHECK_FALSE(owner.observe(5)); // has no pose yet
	CHECK(owner.observe(5, pose));
	network.run(1.0, [&] { CHECK(owner.observe(5)); });
	const std::optional<PoseD> shown = network.session(2).stream(1)->pose(5);
	REQUIRE(shown);
	CHECK(glm::length(shown->translation - pose.translation) < 0.005);
}

TEST_CASE("session: a teleport is not interpolated") {
	SessionNetwork network({ 0.03, 0.02, 0.1 });
	network.join(1);
	network.join(2);
	network.paths[5] = [](double time) { return turned_at(Vector3D(time < 103.0 - 1e-6 ? time - 100.0 : 400.0 + time, 0.0, 0.0), Vector3D(0.0, 1.0, 0.0), 0.0); };
	network.set_owner(5, 1);
	int between = 0;
	int before = 0;
	int after = 0;
	network.run(5.0, [&] {
		if (network.now < 103.0 - 1e-6 && network.now + network.tick >= 103.0 - 1e-6) {
			network.session(1).teleport(5);
		}
		const Receiver *stream = network.session(2).stream(1);
		const std::optional<PoseD> shown = stream != nullptr ? stream->pose(5) : std::nullopt;
		const double x = shown ? shown->translation.x : 0.0;
		between += x > 10.0 && x < 500.0 ? 1 : 0;
		before += x > 0.0 && x <= 10.0 ? 1 : 0;
		after += x >= 500.0 ? 1 : 0;
	});
	CHECK(between == 0);
	CHECK(before > 60);
	CHECK(after > 60);
}

TEST_CASE("session: after a change of the tick length the stream restarts, and its media time increases") {
	SessionNetwork network;
	network.join(1);
	network.join(2);
	for (uint32_t body = 0; body < 4; ++body) {
		network.paths[body] = smooth_path(body);
		network.set_owner(body, 1);
	}
	network.run(3.0);
	for (const double rate : { 30.0, 120.0, 50.0, 60.0 }) {
		network.tick = 1.0 / rate;
		network.step();
		CAPTURE(rate);
		// The stream restarts.
		CHECK(network.session(1).media_time(1) >= 0.0);
		CHECK(network.session(1).media_time(1) <= 2.0 * network.tick);
		double media_time = 0.0;
		network.run(2.0, [&] {
			CHECK(network.session(1).media_time(1) > media_time);
			media_time = network.session(1).media_time(1);
		});
		CHECK(media_time == doctest::Approx(2.0).epsilon(0.03));
		double worst = 0.0;
		network.run(1.0, [&] {
			for (uint32_t body = 0; body < 4; ++body) {
				worst = std::max(worst, network.error(body, 2));
			}
		});
		CHECK(worst <= 1.3);
		CHECK(network.session(2).stream(1)->settings().tick == network.tick);
	}
	CHECK(network.peers[1].poses_rejected == 0);
}

TEST_CASE("session: settings and limits of the playback delay can change at any time") {
	SessionNetwork network = network_of_two();
	network.run(2.0);
	StreamSettings settings;
	settings.position_tolerance = 0.02;
	settings.tick = 1.0; // set by begin_tick only
	network.session(1).set_settings(settings);
	network.run(2.0);
	CHECK(float(network.session(2).stream(1)->settings().position_tolerance) == 0.02f);
	CHECK(network.session(2).stream(1)->settings().tick == network.tick);
	CHECK(network.error(5, 2) <= 1.3);
	CHECK(network.statistics(1, 2).playback_delay < 0.25);
	network.session(2).set_margin_limits(0.3, 0.4);
	network.run(6.0);
	CHECK(network.statistics(1, 2).playback_delay == doctest::Approx(0.3).epsilon(0.1));
	// The limits also hold for streams that are opened later.
	network.close_session(1);
	network.run(0.5);
	network.join(1);
	network.set_owner(1, 5, 1);
	network.run(4.0);
	CHECK(network.statistics(1, 2).playback_delay == doctest::Approx(0.3).epsilon(0.1));
}

TEST_CASE("session: media_time() is 0 if there is no stream") {
	SessionNetwork network;
	network.join(1);
	network.join(2);
	CHECK(network.session(1).media_time(1) == 0.0);
	CHECK(network.session(1).media_time(2) == 0.0);
	CHECK(network.session(1).media_time(99) == 0.0);
	network.paths[5] = smooth_path(5);
	network.set_owner(5, 1);
	network.run(3.0);
	CHECK(network.session(1).media_time(1) == doctest::Approx(3.0).epsilon(0.1));
	CHECK(network.session(2).media_time(1) == network.session(2).stream(1)->media_time());
	CHECK(network.session(2).media_time(1) < network.session(1).media_time(1));
	CHECK(network.session(2).media_time(1) > network.session(1).media_time(1) - 0.4);
	CHECK(network.session(2).media_time(2) == 0.0);
}

TEST_CASE("session: during an outage, no reliable packets accumulate") {
	SessionNetwork network = network_of_two();
	network.run(20.0);
	const double begin = network.now;
	bool is_cut = true;
	network.rewrite = [&](PeerId, PeerId, std::vector<uint8_t> &bytes) {
		if (is_cut) {
			bytes.clear();
		}
	};
	network.run(30.0);
	CHECK(network.packets(2, 1, PacketKind::OPEN, begin).size() >= 5);
	CHECK(std::none_of(network.sent.begin(), network.sent.end(), [&](const SessionNetwork::SentPacket &packet) { return packet.time > begin && packet.reliable; }));
	is_cut = false;
	network.run(2.0);
	CHECK(network.error(5, 2) <= 1.3);
}
