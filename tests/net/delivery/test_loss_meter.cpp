#include "net/delivery/loss_meter.hpp"

#include "../../harness/simulated_link.hpp"

#include <doctest/doctest.h>

using namespace net;

TEST_CASE("loss meter: measures the loss of a link with jitter, and follows its changes") {
	for (const double loss : { 0.0, 0.1, 0.3, 0.6 }) {
		LossMeter meter;
		harness::SimulatedLink link({ 0.05, 0.1, loss }, 7);
		uint8_t received = 0;
		double sum = 0.0;
		const double round_trip = 0.11; // the reports take no time
		int count = 0;
		for (int tick = 0; tick < 6000; ++tick) {
			const double now = tick / 60.0;
			if (tick == 4800) {
				link.settings().loss = 0.0;
			}
			if (tick % 2 == 0) {
				meter.sent(now);
				link.send(now, &received, 1);
			}
			while (link.receive(now)) {
				++received;
				meter.reported(received, now - round_trip);
			}
			if (tick > 600 && tick < 4800) {
				sum += meter.loss();
				++count;
				CHECK(meter.loss() < loss + 0.2);
				CHECK(meter.loss() > loss - 0.2);
			}
		}
		CAPTURE(loss);
		CHECK(sum / count == doctest::Approx(loss).epsilon(0.1).scale(0.3));
		CHECK(meter.loss() < 0.1);
	}
}

TEST_CASE("loss meter: without reports for a long time, it waits for the next two") {
	LossMeter meter;
	double now = 0.0;
	for (int i = 0; i < 1000; ++i) {
		meter.sent(now += 0.01);
	}
	meter.reported(10, now);
	CHECK(meter.loss() == 0.0);
	for (int i = 0; i < 500; ++i) {
		meter.sent(now += 0.01);
	}
	meter.reported(77, now);
	CHECK(meter.loss() == 0.0);
	for (int i = 0; i < 50; ++i) {
		meter.sent(now += 0.01);
	}
	meter.reported(77, now);
	CHECK(meter.loss() > 0.0);
}

TEST_CASE("loss meter: neither a longer round trip nor a new receiver is loss for long") {
	LossMeter meter;
	double now = 0.0;
	uint8_t received = 0;
	const auto run = [&](int packets, double delay) {
		for (int i = 0; i < packets; ++i) {
			meter.sent(now += 0.05);
			received += now > delay ? 1 : 0;
			meter.reported(received, now);
		}
	};
	run(100, 0.0);
	CHECK(meter.loss() < 0.01);
	run(10, 1e9); // a gap: those packets arrive later
	run(50, 0.0);
	received += 10;
	run(100, 0.0);
	CHECK(meter.loss() < 0.03);
	received = 77;
	run(60, 0.0);
	CHECK(meter.loss() < 0.03);
}
