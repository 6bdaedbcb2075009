#include "session_network.hpp"

// The size of packets.

using namespace net;
using namespace net_test;

namespace {

/// Peers 1 and 2. Peer 1 owns `count` bodies, which move smoothly.
SessionNetwork network_of(uint32_t count, const LinkSettings &link = { 0.03 }) {
	SessionNetwork network(link);
	network.join(1);
	network.join(2);
	for (uint32_t body = 0; body < count; ++body) {
		network.paths[body] = smooth_path(body);
		network.set_owner(body, 1);
	}
	return network;
}

StreamSettings with_size(size_t size) {
	StreamSettings settings;
	settings.max_packet_size = size;
	return settings;
}

double worst_error(SessionNetwork &network, uint32_t count) {
	double worst = 0.0;
	for (uint32_t body = 0; body < count; ++body) {
		worst = std::max(worst, network.error(body, 2));
	}
	return worst;
}

size_t largest_packet(const SessionNetwork &network, double since = -1e9) {
	size_t largest = 0;
	for (const SessionNetwork::SentPacket &packet : network.sent) {
		largest = packet.time >= since ? std::max(largest, packet.bytes.size()) : largest;
	}
	return largest;
}

} // namespace

TEST_CASE("session: no packet exceeds max_packet_size, and what is shown is within the tolerance") {
	for (const size_t size : { size_t(256), size_t(576), size_t(1100), size_t(1400), size_t(9000), size_t(65000) }) {
		for (const uint32_t count : { 1u, 60u, 600u }) {
			SessionNetwork network = network_of(count, { 0.03, 0.01, count == 60 ? 0.02 : 0.0 });
			network.session(1).set_settings(with_size(size));
			network.run(2.0);
			CAPTURE(size);
			CAPTURE(count);
			double worst = 0.0;
			network.run(2.0, [&] { worst = std::max(worst, worst_error(network, count)); });
			CHECK(worst <= (count == 60 ? 20.0 : 1.3));
			CHECK(largest_packet(network) + Session::ENGINE_HEADER <= size);
			CHECK((count < 600 || size > 1400 || largest_packet(network) + Session::ENGINE_HEADER + 300 > size));
			CHECK(network.total(2).rejected == 0);
		}
	}
}

TEST_CASE("session: many bodies in violent motion do not exceed what may be in flight") {
	for (const size_t size : { size_t(576), size_t(1100) }) {
		const uint32_t count = size == 576 ? 2000 : 4000;
		SessionNetwork network = network_of(count, { 0.03, 0.02 });
		network.session(1).set_settings(with_size(size));
		for (uint32_t body = 0; body < count; ++body) {
			network.paths[body] = [body](double time) {
				const Vector3D offset(std::sin(time * (20 + body % 17)), std::sin(time * (13 + body % 11)), std::cos(time * (17 + body % 7)));
				return turned_at(0.3 * offset + Vector3D(double(body), 0.0, 0.0), Vector3D(0.6, 0.0, 0.8), std::sin(time * (9 + body % 5)));
			};
		}
		network.run(3.0);
		const double begin = network.now;
		network.run(1.0);
		CAPTURE(size);
		CHECK(worst_error(network, count) <= 2.0);
		const auto packets = network.packets(1, 2, PacketKind::MOTION, begin);
		CHECK(std::none_of(packets.begin(), packets.end(), [](const SessionNetwork::SentPacket &packet) { return packet.bytes[ENVELOPE_BYTES] == 0xe0; })); // a snapshot
	}
}

TEST_CASE("session: max_packet_size can change at any time, without a new media time") {
	SessionNetwork network = network_of(200);
	network.run(2.0);
	double media_time = network.session(1).media_time(1);
	for (const size_t size : { size_t(400), size_t(1400), size_t(300), size_t(256), size_t(100), size_t(1100) }) {
		network.session(1).set_settings(with_size(size));
		const double changed = network.now;
		double worst = 0.0;
		network.run(1.5, [&] {
			worst = std::max(worst, worst_error(network, 200));
			CHECK(network.session(1).media_time(1) > media_time);
			media_time = network.session(1).media_time(1);
		});
		CAPTURE(size);
		CHECK(worst <= 1.3);
		CHECK(largest_packet(network, changed + 1e-6) + Session::ENGINE_HEADER <= std::max(size, size_t(256)));
	}
	CHECK(network.total(2).rejected == 0);
}

TEST_CASE("session: packets that the transport refuses become smaller until it accepts them") {
	for (const size_t limit : { size_t(300), size_t(576), size_t(1000), size_t(1170), size_t(1200) }) {
		for (const size_t size : { size_t(1100), size_t(1400), size_t(60000) }) {
			SessionNetwork network = network_of(300);
			network.session(1).set_settings(with_size(size));
			network.transport_limit = limit;
			network.run(3.0);
			CAPTURE(limit);
			CAPTURE(size);
			CHECK(worst_error(network, 300) <= 1.3);
			CHECK((network.refusals.empty() || size > limit));
			CHECK((!network.refusals.empty() || limit > 1000));
			for (size_t i = 0; i < network.refusals.size(); ++i) {
				CHECK(network.refusals[i] >= 256);
				CHECK(network.refusals[i] < size);
				CHECK((i == 0 || network.refusals[i] <= network.refusals[i - 1]));
			}
			// A larger setting does not override what the transport refuses.
			const size_t refusals = network.refusals.size();
			network.session(1).set_settings(with_size(size + 1000));
			network.run(1.0);
			CHECK((network.refusals.size() == refusals || size <= limit));
		}
	}
	// Refusals of small packets and of unknown peers say nothing.
	SessionNetwork network = network_of(1);
	network.run(0.5);
	CHECK(network.session(1).packet_refused(2, 256) == 1100);
	CHECK(network.session(1).packet_refused(9, 1000) == 1100);
	CHECK(network.session(1).packet_refused(2, 1000) == 750);
	CHECK(network.session(1).packet_refused(2, 300) == 256);
	network.close_session(1);
	network.join(1);
	CHECK(network.session(1).packet_refused(2, 100) == 1100);
}
