#include "playground/handles/steps.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace playground::handles;

TEST_CASE("rounded() gives multiples of the step") {
	CHECK(rounded(0.26, 0.1) == doctest::Approx(0.3));
	CHECK(rounded(-1.7, 0.5) == doctest::Approx(-1.5));
	CHECK(rounded(0.26, 0.0) == 0.26);
	CHECK(rounded(1e300, 1e-300) == 1e300);
	CHECK(rounded(0.26, std::numeric_limits<double>::quiet_NaN()) == 0.26);
	CHECK(rounded(Vector(0.26, 1.0, -0.04), 0.1) == Vector(rounded(0.26, 0.1), 1.0, -0.0));
}

TEST_CASE("rounded_direction() rounds elevation and azimuth") {
	constexpr double DEGREE = 0.017453292519943295;
	CHECK(rounded_direction({ 0.05, 0.998, 0.02 }, 15.0 * DEGREE) == Vector(0.0, 1.0, 0.0));
	CHECK(rounded_direction({ 0.7, 0.05, 0.71 }, 15.0 * DEGREE) == Vector(rounded(0.70710678, 1e-4), 0.0, rounded(0.70710678, 1e-4)));
	CHECK(rounded_direction({ 0.6, 0.0, 0.8 }, 0.0) == Vector(0.6, 0.0, 0.8));
}
