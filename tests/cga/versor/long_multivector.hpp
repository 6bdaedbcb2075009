#pragma once

#include "cga/algebra/multivector.hpp"

#include <algorithm>
#include <array>
#include <cmath>

// The exponential by its definition, in long double (64 bits of fraction on x86): an independent reference with three
// more digits than double.

namespace cga_test {

using LongMultivector = std::array<long double, cga::BLADE_COUNT>;

inline LongMultivector multiplied(const LongMultivector &left, const LongMultivector &right) {
	LongMultivector product{};
	for (unsigned i = 0; i < cga::BLADE_COUNT; ++i) {
		for (unsigned j = 0; j < cga::BLADE_COUNT; ++j) {
			const unsigned a = cga::BLADE_BITMAPS[i];
			const unsigned b = cga::BLADE_BITMAPS[j];
			product[cga::BLADE_INDICES[a ^ b]] += cga::product_sign(a, b) * left[i] * right[j];
		}
	}
	return product;
}

inline LongMultivector long_exp(const cga::Multivector &x) {
	const int halvings = std::max(0, std::ilogb(x.max_abs() + 1e-300) - 1); // squarings lose digits: few of them, and many terms
	LongMultivector small{};
	for (int index = 0; index < cga::BLADE_COUNT; ++index) {
		small[size_t(index)] = std::ldexp((long double)(x[index]), -halvings);
	}
	LongMultivector sum{};
	sum[0] = 1.0L;
	LongMultivector term = sum;
	for (int k = 1; k < 70; ++k) {
		term = multiplied(term, small);
		for (size_t index = 0; index < sum.size(); ++index) {
			term[index] /= k;
			sum[index] += term[index];
		}
	}
	for (int halving = 0; halving < halvings; ++halving) {
		sum = multiplied(sum, sum);
	}
	return sum;
}

// The largest difference of coefficients, relative to the largest coefficient.
inline double relative_error(const cga::Multivector &x, const LongMultivector &expected) {
	long double largest = 0.0L;
	long double difference = 0.0L;
	for (int index = 0; index < cga::BLADE_COUNT; ++index) {
		largest = std::max(largest, std::abs(expected[size_t(index)]));
		difference = std::max(difference, std::abs(expected[size_t(index)] - x[index]));
	}
	return double(difference / largest);
}

inline double relative_error(const cga::Multivector &x, const cga::Multivector &expected) {
	return (x - expected).max_abs() / expected.max_abs();
}

// The smaller of the errors of x and -x.
inline double relative_error_up_to_sign(const cga::Multivector &x, const cga::Multivector &expected) {
	return std::min(relative_error(x, expected), relative_error(-x, expected));
}

} // namespace cga_test
