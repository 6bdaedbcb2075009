#include "cga/batch/float_math.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace cga::float_math;

TEST_CASE("sine and cosine are correct to float's rounding over many periods") {
	double worst = 0.0;
	for (int step = -200000; step <= 200000; ++step) {
		const float x = float(step) * 1e-4f;
		const SinCos both = sin_cos(x);
		worst = std::max({ worst, std::abs(both.sine - std::sin(double(x))), std::abs(both.cosine - std::cos(double(x))) });
	}
	CHECK(worst < 1.2e-7);
	double worst_far = 0.0;
	for (int step = -1571; step <= 1571; ++step) {
		const float x = float(step) + 0.3f;
		const SinCos both = sin_cos(x);
		worst_far = std::max({ worst_far, std::abs(both.sine - std::sin(double(x))), std::abs(both.cosine - std::cos(double(x))) });
	}
	CHECK(worst_far < 2e-7);
	CHECK(sin_cos(0.0f).sine == 0.0f);
	CHECK(sin_cos(0.0f).cosine == 1.0f);
	CHECK(sin_cos(1e-30f).sine == 1e-30f);
}

TEST_CASE("the exponential and the exponential minus one have small relative errors") {
	double worst = 0.0;
	double worst_minus_one = 0.0;
	for (int step = -86000; step <= 86000; ++step) {
		const float x = float(step) * 1e-3f;
		const Exponential both = exponential(x);
		worst = std::max(worst, std::abs(both.value / std::exp(double(x)) - 1.0));
		if (step != 0) {
			worst_minus_one = std::max(worst_minus_one, std::abs(both.minus_one / std::expm1(double(x)) - 1.0));
		}
	}
	CHECK(worst < 2e-7);
	CHECK(worst_minus_one < 3e-7);
	for (const float x : { 1e-3f, -1e-5f, 1e-9f, -1e-20f, 1e-38f }) {
		CAPTURE(x);
		CHECK(std::abs(exponential(x).minus_one / std::expm1(double(x)) - 1.0) < 1.2e-7);
	}
	CHECK(exponential(0.0f).value == 1.0f);
	CHECK(exponential(0.0f).minus_one == 0.0f);
}

TEST_CASE("the exponential stays finite beyond its range") {
	CHECK(exponential(1e30f).value == exponential(87.0f).value);
	CHECK(exponential(-1e30f).value == exponential(-87.0f).value);
	CHECK(exponential(-87.0f).value > 0.0f);
	CHECK(std::isfinite(exponential(87.0f).minus_one));
}
