#pragma once

#include "cga/algebra/multivector.hpp"

namespace cga {

// A Study number k + f W. The context gives W, an element of grade 4 whose square is a scalar. Study numbers commute
// with each other and with the bivectors they come from: the even powers of a bivector B are Study numbers.
struct StudyNumber {
	double number = 0.0; // k
	double four = 0.0; // f

	// (k + f W) X.
	[[nodiscard]] Multivector times(const Multivector &x, const Multivector &w) const {
		return x * number + w.geometric_product(x) * four;
	}
};

[[nodiscard]] constexpr StudyNumber operator+(StudyNumber left, StudyNumber right) {
	return { left.number + right.number, left.four + right.four };
}

[[nodiscard]] constexpr StudyNumber operator*(StudyNumber operand, double factor) {
	return { operand.number * factor, operand.four * factor };
}

// With W^2 = `w_squared`.
[[nodiscard]] constexpr StudyNumber multiplied(StudyNumber left, StudyNumber right, double w_squared) {
	return { left.number * right.number + left.four * right.four * w_squared, left.number * right.four + left.four * right.number };
}

} // namespace cga
