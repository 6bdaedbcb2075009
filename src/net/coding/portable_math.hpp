#pragma once

#include <cmath>

// Functions whose results reach the packets. C libraries round theirs differently; these use only operations that IEEE 754 rounds
// exactly, so that all machines compute the same bits. The relative error is a few 1e-16.

namespace net {

/// The base-2 logarithm of a positive normal number; exact for powers of 2.
[[nodiscard]] inline double portable_log2(double x) {
	int exponent = 0;
	double m = std::frexp(x, &exponent);
	if (m < 0.70710678118654752440) {
		m *= 2.0;
		--exponent;
	}
	// ln m = 2 artanh(s), with |s| < 0.172.
	const double s = (m - 1.0) / (m + 1.0);
	const double y = s * s;
	double sum = 1.0 / 23.0;
	for (int n = 21; n >= 1; n -= 2) {
		sum = sum * y + 1.0 / n;
	}
	return exponent + 2.88539008177792681472 * s * sum; // 2 / ln 2
}

/// 2 to the power of x, for |x| < 1000; exact for integers.
[[nodiscard]] inline double portable_exp2(double x) {
	const double whole = std::floor(x + 0.5);
	const double y = (x - whole) * 0.69314718055994530942; // |y| < 0.35
	double sum = 1.0;
	for (int n = 14; n >= 1; --n) {
		sum = 1.0 + y / n * sum;
	}
	return std::ldexp(sum, int(whole));
}

} // namespace net
