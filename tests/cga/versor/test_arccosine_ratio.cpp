#include "cga/versor/arccosine_ratio.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>

using namespace cga;

namespace {

using LongComplex = std::complex<long double>;

LongComplex reference(LongComplex c) {
	if (std::abs(c - 1.0L) < 1e-6L) {
		return 1.0L + (1.0L - c) / 3.0L + (1.0L - c) * (1.0L - c) * (2.0L / 15.0L);
	}
	return std::acosh(c) / (std::sqrt(c - 1.0L) * std::sqrt(c + 1.0L));
}

} // namespace

TEST_CASE("the ratio of real numbers") {
	CHECK(arccosine_ratio(1.0) == 1.0);
	CHECK(arccosine_ratio(0.0) == doctest::Approx(std::acos(0.0)).epsilon(1e-15));
	CHECK(arccosine_ratio(0.5) == doctest::Approx(std::acos(0.5) / std::sqrt(0.75)).epsilon(1e-15));
	for (const double angle : { 1e-9, 1e-6, 1e-3, 0.5, 2.0, 3.0 }) {
		CHECK(arccosine_ratio(std::cosh(angle)) == doctest::Approx(angle / std::sinh(angle)).epsilon(1e-14));
	}
	CHECK(arccosine_ratio(std::nextafter(1.0, 0.0)) == doctest::Approx(1.0).epsilon(1e-15));
	CHECK(arccosine_ratio(std::nextafter(1.0, 2.0)) == doctest::Approx(1.0).epsilon(1e-15));
}

TEST_CASE("the ratio of Study numbers: half the sum of h(c +- |W|), and half the difference divided by |W|") {
	double worst = 0.0;
	for (const double c : { 0.0, 1e-9, 0.2, 0.49, 0.51, 0.9, 0.999999, 1.0, 1.000001, 1.2, 1.49, 1.51, 3.0, 100.0 }) {
		for (const double length : { 1e-12, 1e-8, 1e-4, 1e-3, 0.01, 0.049, 0.051, 0.1, 0.3, 0.49, 0.51, 0.9, 5.0, 80.0 }) {
			for (const double sign : { 1.0, -1.0 }) {
				if (sign > 0.0 && c - length <= -0.5) {
					continue;
				}
				const LongComplex root = sign > 0.0 ? LongComplex(length, 0.0L) : LongComplex(0.0L, length);
				const LongComplex high = reference((long double)c + root);
				const LongComplex low = reference((long double)c - root);
				const StudyNumber h = arccosine_ratio(c, sign * length * length);
				CAPTURE(c);
				CAPTURE(length);
				CAPTURE(sign);
				const double number = double(std::real((high + low) / 2.0L));
				CHECK(h.number == doctest::Approx(number).epsilon(1e-14));
				// The difference loses digits in the reference where |W| is small: its error is relative to h.
				const LongComplex four = (high - low) / (2.0L * root);
				const double error = std::abs(double(h.four - std::real(four))) * length;
				worst = std::max(worst, error);
			}
		}
	}
	CHECK(worst < 1e-14);
}

TEST_CASE("where W squares to zero, the second part is the derivative (c h - 1) / (1 - c^2)") {
	for (const double c : { 0.0, 0.3, 0.49, 0.51, 0.7, 1.6, 5.0, 1000.0 }) {
		const StudyNumber h = arccosine_ratio(c, 0.0);
		CAPTURE(c);
		CHECK(h.number == doctest::Approx(arccosine_ratio(c)).epsilon(1e-14));
		CHECK(h.four == doctest::Approx((c * arccosine_ratio(c) - 1.0) / (1.0 - c * c)).epsilon(1e-13));
	}
	CHECK(arccosine_ratio(1.0, 0.0).four == doctest::Approx(-1.0 / 3.0).epsilon(1e-15));
}
