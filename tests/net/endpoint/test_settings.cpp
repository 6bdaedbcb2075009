#include "../motion_scenes.hpp"
#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"
#include "net/session/session.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace net;
using namespace net_test;

namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();

struct Setting {
	const char *name;
	double StreamSettings::*member;
	SettingRange range;
};

const Setting SETTINGS[] = {
	{ "position_tolerance", &StreamSettings::position_tolerance, POSITION_TOLERANCE_RANGE },
	{ "position_tolerance_2d", &StreamSettings::position_tolerance_2d, POSITION_TOLERANCE_2D_RANGE },
	{ "rotation_tolerance", &StreamSettings::rotation_tolerance, ROTATION_TOLERANCE_RANGE },
	{ "max_latency", &StreamSettings::max_latency, MAX_LATENCY_RANGE },
	{ "send_rate", &StreamSettings::send_rate, SEND_RATE_RANGE },
	{ "tick", &StreamSettings::tick, TICK_RANGE },
};

bool are_equal(const StreamSettings &a, const StreamSettings &b) {
	return a.is_same_stream(b) && a.send_rate == b.send_rate && a.max_packet_size == b.max_packet_size;
}

/// A sender and a receiver of one body that moves `step` meters and turns `angle` radians in each tick.
struct Stream {
	StreamSettings settings;
	Sender sender;
	Receiver receiver{ 10 };
	double step;
	double angle;
	double now = 0.0;
	int64_t ticks = 0;
	int rejected = 0;
	double error = 0.0; // relative to the tolerance
	int shown = 0; // ticks in which the body was shown

	Stream(const StreamSettings &used, double moved, double turned) :
			settings(used), sender(used), step(moved), angle(turned) {}

	[[nodiscard]] PoseD path(double tick) const {
		// Slower at first, so that the speed changes.
		const double s = tick + 3.0 * std::sin(0.1 * tick);
		return turned_at(Vector3D(step * s, 2.0 * step * std::sin(0.05 * s), 0.0), Vector3D(0.3, 1.0, 0.2), std::remainder(angle * s, 6.28318530717958648));
	}

	void run(int64_t count) {
		const StreamGrid grid(float(settings.position_tolerance), float(settings.rotation_tolerance));
		std::vector<uint8_t> ack;
		for (const int64_t end = ticks + count; ticks < end; ++ticks) {
			now = double(ticks) * settings.tick;
			if (ticks == 0) {
				REQUIRE(sender.add_body(1, path(0.0)));
				sender.add_receiver(1, 0.0);
			}
			REQUIRE(sender.observe(1, now, path(double(ticks))));
			sender.flush(now);
			for (const OutgoingPacket &packet : sender.packets()) {
				rejected += receiver.accept(sender.bytes() + packet.begin, packet.size, now) ? 0 : 1;
			}
			receiver.advance(now);
			receiver.take_ack(ack, now);
			if (!ack.empty()) {
				CHECK(sender.accept(1, ack.data(), ack.size(), now));
			}
			if (const auto pose = receiver.pose(1); pose && receiver.media_time() >= 0.0) {
				++shown;
				error = std::max(error, error_share(*pose, path(receiver.media_time() / settings.tick), grid));
			}
		}
	}
};

} // namespace

TEST_CASE("settings: values at the ends of the ranges are accepted, also after rounding to float32; others change nothing") {
	for (const Setting &setting : SETTINGS) {
		CAPTURE(setting.name);
		const StreamSettings usual;
		REQUIRE(usual.is_valid());
		const double min = setting.range.min;
		const double max = setting.range.max;
		for (const double good : { min, max, std::nextafter(min, max), std::nextafter(max, min), double(std::nextafter(float(min), float(max))) }) {
			CAPTURE(good);
			StreamSettings settings = usual;
			settings.*setting.member = good;
			settings.max_latency = std::min(settings.max_latency, MAX_LATENCY_TICKS * settings.tick);
			Sender sender(usual);
			CHECK(sender.set_settings(settings));
			CHECK(are_equal(sender.settings(), settings));
			CHECK(are_equal(Sender(settings).settings(), settings));
			// Receivers accept it.
			std::vector<uint8_t> bytes;
			put_snapshot_header(bytes, { settings, 0, 0.1f });
			CHECK(read_snapshot_header(bytes.data(), bytes.size()));
		}
		for (const double bad : { std::nextafter(min, -1.0), std::nextafter(max, INFINITE), -min, -max, 0.0, -0.0, 5e-324, -5e-324, 1e-40, 1e300, -1e300, INFINITE, -INFINITE, std::numeric_limits<double>::quiet_NaN() }) {
			CAPTURE(bad);
			StreamSettings settings = usual;
			settings.*setting.member = bad;
			CHECK_FALSE(settings.is_valid());
			Sender sender(usual);
			CHECK_FALSE(sender.set_settings(settings));
			CHECK(are_equal(sender.settings(), usual));
			CHECK(are_equal(Sender(settings).settings(), StreamSettings()));
			if (setting.member != &StreamSettings::tick) {
				CHECK_FALSE(Session(usual).set_settings(settings));
			}
		}
	}
}

TEST_CASE("settings: receivers accept exactly the ranges, rounded to float32") {
	for (const Setting &setting : SETTINGS) {
		if (setting.member == &StreamSettings::send_rate || setting.member == &StreamSettings::tick) {
			continue; // not transmitted, or not rounded
		}
		CAPTURE(setting.name);
		const auto min = float(setting.range.min);
		const auto max = float(setting.range.max);
		const auto accepts = [&](float value) {
			SnapshotHeader header;
			header.settings.*setting.member = double(value);
			header.settings.tick = 0.1;
			std::vector<uint8_t> bytes;
			put_snapshot_header(bytes, header);
			return bool(read_snapshot_header(bytes.data(), bytes.size()));
		};
		CHECK(accepts(min));
		CHECK(accepts(max));
		CHECK_FALSE(accepts(std::nextafter(min, 0.0f)));
		CHECK_FALSE(accepts(std::nextafter(max, 1e30f)));
	}
}

TEST_CASE("settings: a packet size that leaves no room for a session's headers is refused") {
	StreamSettings settings;
	for (const size_t size : { size_t(0), size_t(1), StreamSettings::MIN_PACKET_SIZE - StreamSettings::MAX_PACKET_OVERHEAD - 1, StreamSettings::MAX_PACKET_SIZE + 1, ~size_t(0) }) {
		settings.max_packet_size = size;
		CHECK_FALSE(settings.is_valid());
	}
	CHECK(StreamSettings::MAX_PACKET_OVERHEAD >= ENVELOPE_BYTES + Session::ENGINE_HEADER + Section::HEADER);
}

TEST_CASE("settings: at all corners of the ranges, receivers accept the stream and show it within the tolerance") {
	for (int corner = 0; corner < 32; ++corner) {
		const auto end_of = [corner](int bit, const SettingRange &range) { return (corner >> bit & 1) != 0 ? range.max : range.min; };
		StreamSettings settings;
		settings.position_tolerance = end_of(0, POSITION_TOLERANCE_RANGE);
		settings.rotation_tolerance = end_of(1, ROTATION_TOLERANCE_RANGE);
		settings.tick = end_of(3, TICK_RANGE);
		settings.max_latency = std::min(end_of(2, MAX_LATENCY_RANGE), MAX_LATENCY_TICKS * settings.tick);
		settings.send_rate = end_of(4, SEND_RATE_RANGE);
		CAPTURE(settings.position_tolerance);
		CAPTURE(settings.rotation_tolerance);
		CAPTURE(settings.max_latency);
		CAPTURE(settings.tick);
		CAPTURE(settings.send_rate);
		Stream stream(settings, 0.4 * settings.position_tolerance, std::min(settings.rotation_tolerance * 0.007, 0.3));
		const double seconds = 3.0 * settings.max_latency + 0.5;
		stream.run(int64_t(seconds / settings.tick) + 300);
		CHECK(stream.rejected == 0);
		CHECK(stream.receiver.is_ready());
		CHECK(stream.shown > 200);
		CHECK(stream.error <= 1.3);
	}
}
