#include "../simulated_link.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace bench;

namespace {

constexpr int MANY = 200000;

LinkSettings lossy(double loss, double burst) {
	LinkSettings settings;
	settings.loss = loss;
	settings.burst = burst;
	return settings;
}

struct LossFigures {
	double share = 0.0;
	double burst = 0.0; // mean number lost in a row
};

LossFigures measure_loss(const LinkSettings &settings, uint64_t seed) {
	LinkModel model(settings, seed);
	int lost = 0;
	int bursts = 0;
	bool last = false;
	for (int i = 0; i < MANY; ++i) {
		const bool gone = model.fate(i, 100).copies == 0;
		lost += gone;
		bursts += gone && !last;
		last = gone;
	}
	CHECK(model.sent_count() == MANY);
	CHECK(model.lost_count() == uint64_t(lost));
	return { double(lost) / MANY, double(lost) / std::max(1, bursts) };
}

} // namespace

TEST_CASE("link: without impairment all arrives at once, in order") {
	SimulatedLink link({}, 1);
	for (uint8_t i = 0; i < 3; ++i) {
		link.send(2.0, &i, 1);
	}
	SimulatedLink::Bytes bytes;
	CHECK_FALSE(link.receive(1.999, bytes));
	for (uint8_t i = 0; i < 3; ++i) {
		REQUIRE(link.receive(2.0, bytes));
		CHECK(bytes == SimulatedLink::Bytes{ i });
	}
	CHECK_FALSE(link.receive(9.0, bytes));
}

TEST_CASE("link: delay and jitter are uniform, and let datagrams overtake each other") {
	LinkSettings settings;
	settings.delay = 0.05;
	settings.jitter = 0.03;
	LinkModel model(settings, 7);
	double sum = 0.0;
	double squares = 0.0;
	double least = 1.0;
	double most = 0.0;
	int overtakes = 0;
	double last = 0.0;
	for (int i = 0; i < MANY; ++i) {
		const double sent = 0.01 * i;
		const DatagramFate fate = model.fate(sent, 100);
		REQUIRE(fate.copies == 1);
		const double took = fate.arrivals[0] - sent;
		sum += took;
		squares += took * took;
		least = std::min(least, took);
		most = std::max(most, took);
		overtakes += fate.arrivals[0] < last;
		last = fate.arrivals[0];
	}
	const double mean = sum / MANY;
	CHECK(mean == doctest::Approx(0.065).epsilon(0.002));
	CHECK(std::sqrt(squares / MANY - mean * mean) == doctest::Approx(0.03 / std::sqrt(12.0)).epsilon(0.01));
	CHECK(least >= 0.05 - 1e-9);
	CHECK(most <= 0.08 + 1e-9);
	CHECK(most - least > 0.0299);
	// Two uniform times of width J that are sent d apart: (1 - d / J)^2 / 2.
	CHECK(double(overtakes) / MANY == doctest::Approx(0.5 * std::pow(1.0 - 0.01 / 0.03, 2)).epsilon(0.02));
}

TEST_CASE("link: loss by itself and in bursts has the share and the length asked for") {
	for (const double loss : { 0.01, 0.05, 0.3 }) {
		const LossFigures alone = measure_loss(lossy(loss, 0.0), 11);
		CHECK(alone.share == doctest::Approx(loss).epsilon(0.05));
		CHECK(alone.burst == doctest::Approx(1.0 / (1.0 - loss)).epsilon(0.02));
		const LossFigures bursts = measure_loss(lossy(loss, 5.0), 12);
		CHECK(bursts.share == doctest::Approx(loss).epsilon(0.1));
		CHECK(bursts.burst == doctest::Approx(5.0).epsilon(0.05));
	}
	CHECK(measure_loss(lossy(0.0, 4.0), 3).share == 0.0);
	CHECK(measure_loss(lossy(1.0, 0.0), 3).share == 1.0);
	CHECK(measure_loss(lossy(1.0, 4.0), 3).share == 1.0);
}

TEST_CASE("link: duplicates come as often as asked for") {
	LinkSettings settings;
	settings.duplication = 0.1;
	settings.jitter = 0.01;
	LinkModel model(settings, 5);
	int copies = 0;
	for (int i = 0; i < MANY; ++i) {
		copies += model.fate(i, 100).copies;
	}
	CHECK(double(copies) / MANY == doctest::Approx(1.1).epsilon(0.01));
}

TEST_CASE("link: a limited line makes datagrams wait, and drops those that would wait too long") {
	LinkSettings settings;
	settings.bytes_per_second = 1000.0;
	settings.delay = 0.01;
	settings.longest_queue = 0.36;
	LinkModel model(settings, 5);
	CHECK(model.fate(1.0, 100).arrivals[0] == doctest::Approx(1.11));
	CHECK(model.fate(1.0, 200).arrivals[0] == doctest::Approx(1.31));
	CHECK(model.fate(1.0, 100).copies == 0);
	CHECK(model.fate(1.0, 50).arrivals[0] == doctest::Approx(1.36));
	CHECK(model.fate(5.0, 100).arrivals[0] == doctest::Approx(5.11));
	CHECK(model.lost_count() == 1);
}

TEST_CASE("link: the same seed gives the same fates, another one others") {
	LinkSettings settings = lossy(0.2, 3.0);
	settings.jitter = 0.05;
	settings.duplication = 0.1;
	LinkModel one(settings, 42);
	LinkModel same(settings, 42);
	LinkModel other(settings, 43);
	bool differs = false;
	for (int i = 0; i < 1000; ++i) {
		const DatagramFate a = one.fate(i, 100);
		const DatagramFate b = same.fate(i, 100);
		const DatagramFate c = other.fate(i, 100);
		CHECK(a.copies == b.copies);
		CHECK(a.arrivals == b.arrivals);
		differs = differs || a.copies != c.copies || a.arrivals != c.arrivals;
	}
	CHECK(differs);
}

TEST_CASE("link: the first numbers of a seed are the same everywhere") {
	RandomBits random(5489);
	CHECK(random.unit() == 14514284786278117030u / 2048 * 0x1p-53);
	CHECK(random.unit() == 4620546740167642908u / 2048 * 0x1p-53);
}
