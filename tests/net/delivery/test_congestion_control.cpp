#include "net/delivery/congestion_control.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <deque>

using namespace net;

namespace {

constexpr double TICK = 1.0 / 60.0;
constexpr size_t PACKET = 1100;

/// A sender that always has more to send, and a line with a queue.
struct BusyLine {
	BusyLine(double line_rate, double line_round_trip, int line_lost_of = 0) :
			rate(line_rate), round_trip(line_round_trip), lost_of(line_lost_of) {}

	double rate; // bytes per second
	double round_trip;
	int lost_of; // one packet of so many is lost; 0: none
	double queue = 1e9; // seconds; what would wait longer is lost
	CongestionControl congestion;
	double now = 0.0;
	double free_at = 0.0; // when the queue will be empty
	int count = 0;
	double max_queue = 0.0;
	size_t delivered = 0;
	int sent = 0; // packets
	int dropped = 0; // by the queue
	struct Packet {
		double sent;
		double done;
		bool is_lost;
	};
	std::deque<Packet> packets;

	void run(double seconds) {
		delivered = 0;
		max_queue = 0.0;
		sent = dropped = 0;
		for (const double end = now + seconds; now < end; now += TICK) {
			size_t allowance = congestion.allowance(now);
			for (; allowance > 0; allowance -= std::min(allowance, PACKET)) {
				const bool is_dropped = std::max(free_at, now) - now > queue;
				free_at = std::max(free_at, now) + (is_dropped ? 0.0 : double(PACKET) / rate);
				max_queue = std::max(max_queue, free_at - now);
				packets.push_back({ now, free_at + round_trip, is_dropped || (lost_of > 0 && ++count % lost_of == 0) });
				++sent;
				dropped += is_dropped ? 1 : 0;
				congestion.sent(PACKET);
			}
			congestion.set_limited();
			for (; !packets.empty() && packets.front().done <= now; packets.pop_front()) {
				const Packet &packet = packets.front();
				if (packet.is_lost) {
					congestion.lost(PACKET, packet.sent);
				} else {
					congestion.left(PACKET);
					congestion.acknowledged(PACKET, now - packet.sent, now);
					delivered += PACKET;
				}
			}
		}
	}
};

} // namespace

TEST_CASE("congestion control: it uses most of a line and keeps its queue short") {
	for (const double rate : { 20e3, 100e3, 1e6 }) {
		for (const double round_trip : { 0.02, 0.1, 0.3 }) {
			CAPTURE(rate);
			CAPTURE(round_trip);
			BusyLine line{ rate, round_trip };
			line.run(20.0);
			line.run(10.0);
			CHECK(double(line.delivered) >= 0.6 * 10.0 * rate);
			CHECK(line.max_queue <= 0.2 + 6.0 * double(PACKET) / rate);
		}
	}
}

TEST_CASE("congestion control: a line with a short queue, where no delay shows, is not flooded") {
	for (const double rate : { 5e3, 20e3, 50e3 }) {
		for (const double round_trip : { 0.04, 0.2 }) {
			CAPTURE(rate);
			CAPTURE(round_trip);
			BusyLine line{ rate, round_trip };
			line.queue = std::max(1.1 * double(PACKET) / rate, 0.03); // a tick's packets are sent at once
			line.run(20.0);
			line.run(20.0);
			CHECK(double(line.delivered) >= 0.4 * 20.0 * rate);
			CHECK(line.dropped <= 0.25 * line.sent);
		}
	}
}

TEST_CASE("congestion control: an outage does not reduce it") {
	CongestionControl congestion;
	double now = 0.0;
	const auto exchange = [&](bool arrives) {
		for (int i = 0; i < 40; ++i, now += 0.05) {
			congestion.sent(PACKET);
			if (arrives) {
				congestion.left(PACKET);
				congestion.acknowledged(PACKET, 0.05, now + 0.05);
			} else {
				congestion.lost(PACKET, now);
			}
		}
	};
	exchange(true);
	const size_t before = congestion.allowance(now);
	exchange(false);
	exchange(true);
	CHECK(congestion.allowance(now) >= before / 2);
	CHECK_FALSE(congestion.is_limiting());
}

TEST_CASE("congestion control: loss that does not depend on what is sent does not reduce it for long") {
	BusyLine clean{ 1e6, 0.05 };
	BusyLine lossy{ 1e6, 0.05, 10 };
	clean.run(20.0);
	lossy.run(20.0);
	clean.run(10.0);
	lossy.run(10.0);
	CHECK(double(lossy.delivered) >= 0.5 * double(clean.delivered));
}

TEST_CASE("congestion control: timeouts before the first acknowledgement say nothing, as the round trip may be longer") {
	CongestionControl congestion;
	const size_t before = congestion.allowance(0.0);
	for (int i = 0; i < 100; ++i) {
		congestion.sent(PACKET);
		congestion.lost(PACKET, 0.0);
	}
	CHECK(congestion.allowance(1.0) == before);
}

TEST_CASE("congestion control: one packet may be in flight, whatever the window") {
	BusyLine line{ 2e3, 0.05, 2 };
	line.run(60.0);
	line.run(20.0);
	CHECK(line.delivered >= 3 * PACKET);
}
