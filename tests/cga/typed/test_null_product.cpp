#include "cga/typed/null_product.hpp"

#include "cga/algebra/null_basis.hpp"
#include "cga/algebra/null_coefficients.hpp"

#include <doctest/doctest.h>

using namespace cga;
using namespace cga::typed;

namespace {

Multivector null_blade(int index) {
	Multivector::Coefficients coefficients{};
	coefficients[size_t(index)] = 1.0;
	return from_null_coefficients(coefficients);
}

using Multiply = Multivector (Multivector::*)(const Multivector &) const;

void check_table(Product product, Multiply multiply) {
	for (int left = 0; left < BLADE_COUNT; ++left) {
		for (int right = 0; right < BLADE_COUNT; ++right) {
			const Multivector::Coefficients wanted = to_null_coefficients((null_blade(left).*multiply)(null_blade(right)));
			for (int index = 0; index < BLADE_COUNT; ++index) {
				CAPTURE(blade_name(left).view());
				CAPTURE(blade_name(right).view());
				CHECK(null_sign(product, left, right, index) == wanted[size_t(index)]);
			}
		}
	}
}

} // namespace

TEST_CASE("e_inf e_o = -1 + E, and the squares of both are zero") {
	CHECK(null_sign(Product::GEOMETRIC, E4, E5, 0) == -1);
	CHECK(null_sign(Product::GEOMETRIC, E4, E5, E45) == 1);
	CHECK(null_sign(Product::GEOMETRIC, E5, E4, E45) == -1);
	for (int index = 0; index < BLADE_COUNT; ++index) {
		CHECK(null_sign(Product::GEOMETRIC, E4, E4, index) == 0);
		CHECK(null_sign(Product::GEOMETRIC, E5, E5, index) == 0);
	}
	CHECK(null_blade(E4) == e_infinity());
	CHECK(null_blade(E5) == e_origin());
}

TEST_CASE("each product of all pairs of null blades agrees with Multivector's") {
	check_table(Product::GEOMETRIC, &Multivector::geometric_product);
	check_table(Product::OUTER, &Multivector::outer_product);
	check_table(Product::INNER, &Multivector::inner_product);
	check_table(Product::LEFT_CONTRACTION, &Multivector::left_contraction);
	check_table(Product::RIGHT_CONTRACTION, &Multivector::right_contraction);
	check_table(Product::COMMUTATOR, &Multivector::commutator_product);
}
