#include "../simulated_link.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace harness;

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
	double burst = 0.0; // mean length
};

LossFigures measure_loss(const LinkSettings &settings, uint64_t seed) {
	LinkModel model(settings, seed);
	int lost = 0;
	int bursts = 0;
	bool was_lost = false;
	for (int i = 0; i < MANY; ++i) {
		const bool is_lost = model.fate(i, 100).copies == 0;
		lost += is_lost;
		bursts += is_lost && !was_lost;
		was_lost = is_lost;
	}
	CHECK(model.sent_count() == MANY);
	CHECK(model.lost_count() == uint64_t(lost));
	return { double(lost) / MANY, double(lost) / std::max(1, bursts) };
}

} // namespace

TEST_CASE("link: without impairment datagrams arrive at once, in order") {
	SimulatedLink link({}, 1);
	for (uint8_t i = 0; i < 3; ++i) {
		link.send(2.0, &i, 1);
	}
	CHECK(link.next_arrival() == 2.0);
	CHECK_FALSE(link.receive(1.999));
	for (uint8_t i = 0; i < 3; ++i) {
		const std::optional<Delivery> delivery = link.receive(2.0);
		REQUIRE(delivery);
		CHECK(delivery->arrival == 2.0);
		CHECK(delivery->bytes == std::vector<uint8_t>{ i });
	}
	CHECK_FALSE(link.receive(9.0));
	CHECK(std::isinf(link.next_arrival()));
}

TEST_CASE("link: transit times are uniformly distributed, and jitter reorders datagrams") {
	LinkSettings settings;
	settings.delay = 0.05;
	settings.jitter = 0.03;
	LinkModel model(settings, 7);
	double sum = 0.0;
	double squares = 0.0;
	double min = 1.0;
	double max = 0.0;
	int reordered = 0;
	double last = 0.0;
	for (int i = 0; i < MANY; ++i) {
		const double sent = 0.01 * i;
		const DatagramFate fate = model.fate(sent, 100);
		REQUIRE(fate.copies == 1);
		const double transit = fate.arrivals[0] - sent;
		sum += transit;
		squares += transit * transit;
		min = std::min(min, transit);
		max = std::max(max, transit);
		reordered += fate.arrivals[0] < last;
		last = fate.arrivals[0];
	}
	const double mean = sum / MANY;
	CHECK(mean == doctest::Approx(0.065).epsilon(0.002));
	CHECK(std::sqrt(squares / MANY - mean * mean) == doctest::Approx(0.03 / std::sqrt(12.0)).epsilon(0.01));
	CHECK(min >= 0.05 - 1e-9);
	CHECK(max <= 0.08 + 1e-9);
	CHECK(max - min > 0.0299);
	// Two transit times, uniform over a width J, of datagrams sent d apart: the probability is (1 - d / J)^2 / 2.
	CHECK(double(reordered) / MANY == doctest::Approx(0.5 * std::pow(1.0 - 0.01 / 0.03, 2)).epsilon(0.02));
}

TEST_CASE("link: independent losses and bursts have the configured probability and mean length") {
	for (const double loss : { 0.01, 0.05, 0.3 }) {
		const LossFigures independent = measure_loss(lossy(loss, 0.0), 11);
		CHECK(independent.share == doctest::Approx(loss).epsilon(0.05));
		CHECK(independent.burst == doctest::Approx(1.0 / (1.0 - loss)).epsilon(0.02));
		const LossFigures bursts = measure_loss(lossy(loss, 5.0), 12);
		CHECK(bursts.share == doctest::Approx(loss).epsilon(0.1));
		CHECK(bursts.burst == doctest::Approx(5.0).epsilon(0.05));
	}
	CHECK(measure_loss(lossy(0.0, 4.0), 3).share == 0.0);
	CHECK(measure_loss(lossy(1.0, 0.0), 3).share == 1.0);
	CHECK(measure_loss(lossy(1.0, 4.0), 3).share == 1.0);
}

TEST_CASE("link: duplicates have the configured probability") {
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

TEST_CASE("link: limited bandwidth queues datagrams, and drops those that would wait too long") {
	LinkSettings settings;
	settings.bytes_per_second = 1000.0;
	settings.delay = 0.01;
	settings.max_queue = 0.36;
	LinkModel model(settings, 5);
	CHECK(model.fate(1.0, 100).arrivals[0] == doctest::Approx(1.11));
	CHECK(model.fate(1.0, 200).arrivals[0] == doctest::Approx(1.31));
	CHECK(model.fate(1.0, 100).copies == 0);
	CHECK(model.fate(1.0, 50).arrivals[0] == doctest::Approx(1.36));
	CHECK(model.fate(5.0, 100).arrivals[0] == doctest::Approx(5.11));
	CHECK(model.lost_count() == 1);
}

TEST_CASE("link: an outage loses everything sent in it, and settings may change between datagrams") {
	SimulatedLink link({ 0.5 }, 1);
	CHECK(link.model().last_loss_time() < -1e300);
	link.settings().outage_begin = 1.0;
	link.settings().outage_end = 3.0;
	for (uint8_t i = 0; i < 5; ++i) {
		link.send(i, &i, 1);
	}
	link.settings().delay = 0.25;
	const uint8_t last = 5;
	link.send(4.0, &last, 1);
	std::vector<std::pair<double, uint8_t>> received;
	while (const std::optional<Delivery> delivery = link.receive(10.0)) {
		received.emplace_back(delivery->arrival, delivery->bytes.front());
	}
	CHECK(received == std::vector<std::pair<double, uint8_t>>{ { 0.5, 0 }, { 3.5, 3 }, { 4.25, 5 }, { 4.5, 4 } });
	CHECK(link.model().sent_count() == 6);
	CHECK(link.model().lost_count() == 2);
	CHECK(link.model().last_loss_time() == 2.0);
}

TEST_CASE("link: the same seed gives the same fates, another seed different ones") {
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

TEST_CASE("link: random numbers of a seed are the same on every platform") {
	RandomBits random(5489);
	CHECK(random.unit() == double(14514284786278117030u >> 11) * 0x1p-53);
	CHECK(random.unit() == double(4620546740167642908u >> 11) * 0x1p-53);
}
