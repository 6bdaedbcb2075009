#include "net/delivery/arrival_line.hpp"

#include <doctest/doctest.h>

using namespace net;

namespace {

/// Windows of 0.1 s that arrive as they end, on a local clock that starts at 1000.
struct Arrivals {
	ArrivalLine line;
	double media = 0.0;
	double now = 1000.0;

	Arrivals() { line.start(media, now); }

	/// The next window, `late` seconds later than its length.
	ArrivalLine::Arrival add(double late = 0.0, bool has_losses = false) {
		media += 0.1;
		now += 0.1 + late;
		return line.add(media, now, has_losses);
	}
};

} // namespace

TEST_CASE("arrival line: regular arrivals are expected, and the newest media time is the last one's") {
	Arrivals arrivals;
	for (int i = 0; i < 50; ++i) {
		CHECK(arrivals.add() == ArrivalLine::Arrival::EXPECTED);
	}
	CHECK(arrivals.line.newest_at(arrivals.now) == doctest::Approx(arrivals.media));
	CHECK(arrivals.line.newest_at(arrivals.now + 0.05) == doctest::Approx(arrivals.media + 0.05));
	CHECK(arrivals.line.rate() == 1.0);
	CHECK(arrivals.line.jitter() == doctest::Approx(0.0));
}

TEST_CASE("arrival line: one late arrival does not move it, a second one does") {
	Arrivals arrivals;
	for (int i = 0; i < 50; ++i) {
		(void)arrivals.add();
	}
	CHECK(arrivals.add(0.5) == ArrivalLine::Arrival::SUSPECT);
	CHECK(arrivals.line.newest_at(arrivals.now) == doctest::Approx(arrivals.media + 0.5));
	CHECK(arrivals.add(-0.5) == ArrivalLine::Arrival::EXPECTED);
	CHECK(arrivals.line.newest_at(arrivals.now) == doctest::Approx(arrivals.media));
	CHECK(arrivals.add(0.5) == ArrivalLine::Arrival::SUSPECT);
	CHECK(arrivals.add() == ArrivalLine::Arrival::MOVED);
	CHECK(arrivals.line.newest_at(arrivals.now) == doctest::Approx(arrivals.media));
	CHECK(arrivals.line.rate() == doctest::Approx(1.0));
}

TEST_CASE("arrival line: arrivals that are ever later are a slower sender") {
	Arrivals arrivals;
	for (int i = 0; i < 50; ++i) {
		(void)arrivals.add();
	}
	CHECK(arrivals.add(0.05) == ArrivalLine::Arrival::SUSPECT);
	CHECK(arrivals.add(0.05) == ArrivalLine::Arrival::MOVED);
	CHECK(arrivals.line.rate() == doctest::Approx(0.1 / 0.15).epsilon(1e-6));
	for (int i = 0; i < 20; ++i) {
		CHECK(arrivals.add(0.05) == ArrivalLine::Arrival::EXPECTED);
	}
	CHECK(arrivals.line.newest_at(arrivals.now) == doctest::Approx(arrivals.media));
	for (int i = 0; i < 40; ++i) {
		(void)arrivals.add();
	}
	CHECK(arrivals.line.rate() == doctest::Approx(1.0).epsilon(0.02));
}

TEST_CASE("arrival line: a slow sender whose arrivals are about as late as the bound is followed too") {
	for (const double late : { 0.06, 0.08, 0.1, 0.12, 0.15 }) {
		Arrivals arrivals;
		for (int i = 0; i < 20; ++i) {
			(void)arrivals.add(i % 2 == 0 ? late + 0.008 : late - 0.008);
		}
		CAPTURE(late);
		CHECK(arrivals.line.rate() == doctest::Approx(0.1 / (0.1 + late)).epsilon(0.05));
		CHECK(arrivals.add(late) == ArrivalLine::Arrival::EXPECTED);
	}
}

TEST_CASE("arrival line: a long silence says nothing about the slope") {
	Arrivals arrivals;
	for (int i = 0; i < 50; ++i) {
		(void)arrivals.add();
	}
	CHECK(arrivals.add(60.0) == ArrivalLine::Arrival::SUSPECT);
	CHECK(arrivals.add() == ArrivalLine::Arrival::MOVED);
	CHECK(arrivals.line.rate() == doctest::Approx(1.0));
	CHECK(arrivals.line.newest_at(arrivals.now) == doctest::Approx(arrivals.media));
}

TEST_CASE("arrival line: retransmissions do not move it") {
	Arrivals arrivals;
	for (int i = 0; i < 50; ++i) {
		(void)arrivals.add();
	}
	CHECK(arrivals.add(0.4, true) == ArrivalLine::Arrival::EXPECTED);
	CHECK(arrivals.add(0.1, true) == ArrivalLine::Arrival::EXPECTED);
	CHECK(arrivals.line.newest_at(arrivals.now) > arrivals.media + 0.4);
	CHECK(arrivals.line.jitter() > 0.4);
}
