#include "net/session/traffic_meter.hpp"

#include <doctest/doctest.h>

using namespace net;

TEST_CASE("traffic meter: bytes and packets of the last second") {
	for (const double start : { 0.0, 12345.0 }) {
		TrafficMeter meter;
		CHECK(meter.bytes_per_second(start) == 0.0);
		for (int i = 0; i < 60; ++i) {
			meter.add(100, start + i / 60.0);
		}
		CHECK(meter.bytes_per_second(start + 1.0) == 6000.0);
		CHECK(meter.packets_per_second(start + 1.0) == 60.0);
		CHECK(meter.bytes_per_second(start + 1.5) == doctest::Approx(3000.0).epsilon(0.05));
		CHECK(meter.packets_per_second(start + 2.2) == 0.0);
		meter.add(7, start + 100.0);
		CHECK(meter.bytes_per_second(start + 100.9) == 7.0);
		CHECK(meter.packets_per_second(start + 100.9) == 1.0);
		CHECK(meter.bytes_per_second(start + 1000.0) == 0.0);
	}
}
