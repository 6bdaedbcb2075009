#include "cga/versor/arccosine_ratio.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace cga;

namespace {

// std::complex<long double> is wrong or crashes with some compilers for Windows.
struct LongComplex {
	long double real = 0.0L, imaginary = 0.0L;
};

LongComplex operator+(LongComplex a, LongComplex b) {
	return { a.real + b.real, a.imaginary + b.imaginary };
}

LongComplex operator*(LongComplex a, LongComplex b) {
	return { a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real };
}

LongComplex operator-(LongComplex a, LongComplex b) {
	return a + b * LongComplex{ -1.0L };
}

LongComplex operator/(LongComplex a, LongComplex b) {
	const long double squared = b.real * b.real + b.imaginary * b.imaginary;
	return a * LongComplex{ b.real / squared, -b.imaginary / squared };
}

long double length_of(LongComplex z) {
	return std::sqrt(z.real * z.real + z.imaginary * z.imaginary);
}

LongComplex square_root(LongComplex z) {
	const long double size = std::sqrt(0.5L * (length_of(z) + std::abs(z.real)));
	if (size == 0.0L) {
		return {};
	}
	const long double other = z.imaginary / (2.0L * size);
	return z.real >= 0.0L ? LongComplex{ size, other } : LongComplex{ std::abs(other), std::copysign(size, z.imaginary) };
}

LongComplex reference(LongComplex c) {
	const LongComplex one = { 1.0L };
	const LongComplex d = one - c;
	if (length_of(d) < 1e-6L) {
		return one + d * LongComplex{ 1.0L / 3.0L } + d * d * LongComplex{ 2.0L / 15.0L };
	}
	const LongComplex root = square_root(c - one) * square_root(c + one);
	const LongComplex sum = c + root;
	return LongComplex{ std::log(length_of(sum)), std::atan2(sum.imaginary, sum.real) } / root;
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
				const LongComplex root = sign > 0.0 ? LongComplex{ length } : LongComplex{ 0.0L, length };
				const LongComplex high = reference(LongComplex{ c } + root);
				const LongComplex low = reference(LongComplex{ c } - root);
				const StudyNumber h = arccosine_ratio(c, sign * length * length);
				CAPTURE(c);
				CAPTURE(length);
				CAPTURE(sign);
				const double number = double((high + low).real / 2.0L);
				CHECK(h.number == doctest::Approx(number).epsilon(1e-14));
				// The difference loses digits in the reference where |W| is small: its error is relative to h.
				const LongComplex four = (high - low) / (root + root);
				const double error = std::abs(double(h.four - four.real)) * length;
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
