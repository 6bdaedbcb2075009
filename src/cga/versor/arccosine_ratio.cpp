#include "cga/versor/arccosine_ratio.hpp"

#include <cmath>
#include <complex>

namespace cga {

namespace {

// The platforms' acosh() and log1p() differ in precision, so none is used.

// Below this distance from 1, the series for real numbers converges within MAX_TERMS.
constexpr double NEAR_ONE = 0.25;
constexpr int MAX_TERMS = 18;

// h(c) = sum of k! / (1 3 5 ... (2 k + 1)) (1 - c)^k, about 1. The terms shrink by (1 - c) / 2.
double series_about_one(double c) {
	double term = 1.0;
	double sum = 0.0;
	for (int k = 0; k < MAX_TERMS; ++k) {
		sum += term;
		term *= (1.0 - c) * ((k + 1.0) / (2.0 * k + 3.0));
	}
	return sum;
}

// The same for Study numbers.
StudyNumber series_about_one(double c, double w_squared) {
	const StudyNumber d = { 1.0 - c, -1.0 };
	StudyNumber term = { 1.0, 0.0 };
	StudyNumber sum;
	for (int k = 0; k < 28; ++k) {
		sum = sum + term;
		term = multiplied(term, d, w_squared) * ((k + 1.0) / (2.0 * k + 3.0));
	}
	return sum;
}

// Taylor's series about c in W, from h's differential equation (1 - c^2) h' = c h - 1; the coefficients a_k follow
//   (1 - c^2) (k + 1) a_k+1 = (2 k + 1) c a_k + k a_k-1.
// The terms shrink by |W| / (1 + c).
StudyNumber series_about(double c, double w_squared) {
	const double remainder = (1.0 - c) * (1.0 + c);
	double previous = 0.0;
	double coefficient = arccosine_ratio(c);
	double power = 1.0; // W^k or W^(k - 1), a number
	StudyNumber sum;
	for (int k = 0; k < 14; ++k) {
		if (k % 2 == 0) {
			sum.number += coefficient * power;
		} else {
			sum.four += coefficient * power;
			power *= w_squared;
		}
		const double next = ((2.0 * k + 1.0) * c * coefficient + k * previous - (k == 0 ? 1.0 : 0.0)) / ((k + 1.0) * remainder);
		previous = coefficient;
		coefficient = next;
	}
	return sum;
}

} // namespace

double arccosine_ratio(double c) {
	if (std::abs(1.0 - c) < NEAR_ONE) {
		return series_about_one(c);
	}
	const double root = std::sqrt(std::abs((1.0 - c) * (1.0 + c)));
	return (c < 1.0 ? std::acos(c) : std::log(c + root)) / root;
}

StudyNumber arccosine_ratio(double c, double w_squared) {
	const double length = std::sqrt(std::abs(w_squared));
	if (std::abs(1.0 - c) + length <= 0.5) {
		return series_about_one(c, w_squared);
	}
	if (length <= 0.05 * (1.0 + c)) {
		return series_about(c, w_squared);
	}
	if (w_squared > 0.0) {
		const double high = arccosine_ratio(c + length);
		const double low = arccosine_ratio(c - length);
		return { 0.5 * (high + low), 0.5 * (high - low) / length };
	}
	// W is `length` times an imaginary unit.
	const std::complex<double> z(c, length);
	const std::complex<double> root = std::sqrt(z - 1.0) * std::sqrt(z + 1.0);
	const std::complex<double> ratio = std::log(z + root) / root;
	return { ratio.real(), ratio.imag() / length };
}

} // namespace cga
