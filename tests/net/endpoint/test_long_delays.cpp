#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace net;

namespace {

/// A body that goes somewhere else in each tick, so that each tick takes a segment.
double place(int64_t tick) {
	const uint32_t hash = uint32_t(tick) * 2654435761u;
	return double(hash >> 24) / 256.0;
}

struct Row {
	double tick;
	double max_latency;
	double min_delay; // of the receiver; 0 for none
	int64_t ticks; // of the test
};

} // namespace

TEST_CASE("long delays: playback shows the motion at its media time, however many ticks it stands back") {
	for (const Row &row : { Row{ 1.0 / 60.0, 5.0, 0.0, 1200 }, Row{ 1.0 / 60.0, 10.0, 10.0, 2400 }, Row{ 1e-3, 2.048, 0.0, 6000 }, Row{ 1e-4, 0.2, 10.0, 9000 } }) {
		CAPTURE(row.tick);
		CAPTURE(row.max_latency);
		StreamSettings settings;
		settings.tick = row.tick;
		settings.max_latency = row.max_latency;
		REQUIRE(settings.is_valid());
		Sender sender(settings);
		Receiver receiver;
		if (row.min_delay > 0.0) {
			receiver.set_margin_limits(row.min_delay, 10.0);
		}
		std::vector<uint8_t> ack;
		REQUIRE(sender.add_body(1, {}));
		sender.add_receiver(7, 0.0);
		double worst = 0.0;
		double longest = 0.0;
		for (int64_t tick = 0; tick < row.ticks; ++tick) {
			const double now = double(tick) * row.tick;
			cga::Pose<double> pose;
			pose.translation.x = place(tick);
			REQUIRE(sender.observe(1, now, pose));
			sender.flush(now);
			for (const OutgoingPacket &packet : sender.packets()) {
				REQUIRE(receiver.accept(sender.bytes() + packet.begin, packet.size, now));
			}
			receiver.advance(now);
			receiver.take_ack(ack, now);
			if (!ack.empty()) {
				REQUIRE(sender.accept(7, ack.data(), ack.size(), now));
			}
			// Poses are defined at whole ticks.
			const double shown = std::ceil(receiver.media_time() / row.tick - 1e-6);
			if (receiver.is_ready() && shown > 1.0 && shown * row.tick <= receiver.known_time()) {
				const auto found = receiver.pose_at(1, shown * row.tick);
				REQUIRE(found);
				worst = std::max(worst, std::fabs(found->translation.x - place(int64_t(shown))));
				longest = std::max(longest, receiver.known_time() / row.tick - shown);
			}
		}
		CHECK(worst <= 1.1 * settings.position_tolerance);
		CHECK(longest >= 256.0);
	}
}
