#include "net/delivery/recent_extreme.hpp"

#include <doctest/doctest.h>

using namespace net;

TEST_CASE("recent extreme: it covers the current span and the one before") {
	RecentExtreme largest(1.0, 2.0);
	CHECK(largest.is_empty());
	largest.add(5.0, 0.0);
	largest.add(3.0, 1.0);
	CHECK(largest.value() == 5.0);
	largest.add(1.0, 2.5); // a new span: the previous one still counts
	CHECK(largest.value() == 5.0);
	largest.add(2.0, 5.0);
	CHECK(largest.value() == 2.0);
	RecentExtreme smallest(-1.0, 2.0);
	smallest.add(-1.0, 0.0);
	smallest.add(4.0, 0.5);
	CHECK(smallest.value() == -1.0);
}
