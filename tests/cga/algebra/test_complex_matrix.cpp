#include "cga/algebra/complex_matrix.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

using namespace cga;
using cga_test::Random;

namespace {

ComplexMatrix multiplied(const ComplexMatrix &left, const ComplexMatrix &right) {
	ComplexMatrix product{};
	for (size_t row = 0; row < 4; ++row) {
		for (size_t column = 0; column < 4; ++column) {
			for (size_t k = 0; k < 4; ++k) {
				product[row][column] += left[row][k] * right[k][column];
			}
		}
	}
	return product;
}

} // namespace

TEST_CASE("basis blades multiply as their matrices do, without rounding") {
	for (int left = 0; left < BLADE_COUNT; ++left) {
		for (int right = 0; right < BLADE_COUNT; ++right) {
			const Multivector a = Multivector::basis_blade(left);
			const Multivector b = Multivector::basis_blade(right);
			REQUIRE(from_matrix(multiplied(to_matrix(a), to_matrix(b))) == a.geometric_product(b));
		}
	}
}

TEST_CASE("the pseudoscalar is the imaginary unit") {
	const ComplexMatrix matrix = to_matrix(*Multivector::basis("I"));
	for (size_t row = 0; row < 4; ++row) {
		for (size_t column = 0; column < 4; ++column) {
			CHECK(matrix[row][column] == std::complex<double>(0.0, row == column ? 1.0 : 0.0));
		}
	}
}

TEST_CASE("round trips and products of random elements") {
	Random random(10);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const Multivector a = random.multivector();
		const Multivector b = random.multivector();
		CHECK(from_matrix(to_matrix(a)).is_equal_approx(a, 1e-14));
		CHECK(from_matrix(multiplied(to_matrix(a), to_matrix(b))).is_equal_approx(a.geometric_product(b), 1e-13));
	}
}

TEST_CASE("the inverse of a matrix, with pivots in any rows and columns") {
	Random random(11);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		ComplexMatrix matrix = to_matrix(random.multivector());
		if (repeat % 3 == 0) {
			matrix[0][0] = matrix[1][1] = matrix[2][2] = 0.0;
		}
		const auto inverse = inverse_matrix(matrix);
		REQUIRE(inverse.has_value());
		double largest = 0.0;
		for (const auto &row : *inverse) {
			for (const std::complex<double> &entry : row) {
				largest = std::max(largest, std::abs(entry));
			}
		}
		const ComplexMatrix product = multiplied(matrix, *inverse);
		for (size_t row = 0; row < 4; ++row) {
			for (size_t column = 0; column < 4; ++column) {
				CHECK(std::abs(product[row][column] - (row == column ? 1.0 : 0.0)) < 1e-13 * (1.0 + 10.0 * largest));
			}
		}
	}
	CHECK_FALSE(inverse_matrix(ComplexMatrix{}).has_value());
	CHECK_FALSE(inverse_matrix(to_matrix(Multivector::scalar(1.0) + Multivector::basis_blade(1))).has_value());
}
