#include "../line.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

using namespace bench;

namespace {

constexpr size_t SIZE = 1000; // bytes of each datagram

// Sends datagrams at a constant rate from time 0 on and returns when each arrives; infinity if it was dropped.
std::vector<double> arrivals(const LineSettings &settings, size_t count, double interval) {
	Line line(settings, 1);
	std::vector<double> result(count, std::numeric_limits<double>::infinity());
	const auto receive = [&](double now) {
		while (const auto delivery = line.receive(now)) {
			result[size_t(delivery->bytes[0])] = delivery->arrival;
		}
	};
	for (size_t i = 0; i < count; ++i) {
		std::vector<uint8_t> bytes(SIZE, uint8_t(i));
		line.send(double(i) * interval, bytes.data(), bytes.size());
		receive(double(i) * interval);
	}
	receive(1e6);
	return result;
}

size_t arrived(const std::vector<double> &times) {
	return size_t(std::count_if(times.begin(), times.end(), [](double time) { return time < 1e6; }));
}

LineSettings line_of(std::vector<LineRate> rates, double queue) {
	LineSettings settings;
	settings.path.delay = 0.1;
	settings.rates = std::move(rates);
	settings.queue = queue;
	return settings;
}

} // namespace

TEST_CASE("line: without a bottleneck, only the path delays") {
	for (const double time : arrivals(line_of({}, 0.2), 5, 0.0)) {
		CHECK(time == doctest::Approx(0.1));
	}
}

TEST_CASE("line: a bottleneck transmits one datagram after the other") {
	const std::vector<double> times = arrivals(line_of({ { 0.0, 10e3 } }, 10.0), 5, 0.0);
	for (size_t i = 0; i < times.size(); ++i) {
		CHECK(times[i] == doctest::Approx(0.1 + 0.1 * double(i + 1)));
	}
}

TEST_CASE("line: the queue drops what does not fit, and what passes has the rate of the line") {
	// Twice the rate for 20 s, and a queue of 1 s: 10 datagrams per second and those in the queue pass.
	const std::vector<double> times = arrivals(line_of({ { 0.0, 10e3 } }, 1.0), 200, 0.05);
	CHECK(arrived(times) >= 108);
	CHECK(arrived(times) <= 111);
	for (size_t i = 0; i < times.size(); ++i) {
		const double delay = times[i] - 0.05 * double(i);
		CHECK((delay > 1e6 || delay <= 1.1 + 1e-9));
	}
}

TEST_CASE("line: a policer drops without delaying") {
	LineSettings settings = line_of({ { 0.0, 10e3 } }, 1.0);
	settings.polices = true;
	const std::vector<double> times = arrivals(settings, 200, 0.05);
	CHECK(arrived(times) >= 108);
	CHECK(arrived(times) <= 111);
	for (size_t i = 0; i < times.size(); ++i) {
		CHECK((times[i] > 1e6 || times[i] == doctest::Approx(0.1 + 0.05 * double(i))));
	}
}

TEST_CASE("line: a change of the rate applies to what is being transmitted") {
	// 1,000 bytes: 500 in the first 0.05 s, and the rest at a tenth of the rate.
	CHECK(arrivals(line_of({ { 0.0, 10e3 }, { 0.05, 1e3 } }, 1.0), 1, 0.0)[0] == doctest::Approx(0.1 + 0.05 + 0.5));
	CHECK(arrivals(line_of({ { 0.0, 10e3 }, { 0.05, 0.0 } }, 1.0), 1, 0.0)[0] == doctest::Approx(0.1 + 0.05));
}
