#include "net/session/repetition.hpp"

#include <doctest/doctest.h>

using namespace net;

TEST_CASE("repetition: pauses double up to the maximum, and restart") {
	Repetition repetition(4.0);
	for (int round = 0; round < 2; ++round) {
		double now = 10.0 * round + 1.0;
		repetition.restart(now);
		CHECK_FALSE(repetition.is_due(now - 0.001));
		for (const double pause : { 0.25, 0.5, 1.0, 2.0, 4.0, 4.0, 4.0 }) {
			CHECK(repetition.is_due(now));
			repetition.back_off(now);
			now += pause;
			CHECK_FALSE(repetition.is_due(now - 0.001));
		}
	}
}
