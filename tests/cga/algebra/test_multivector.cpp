#include "cga/algebra/multivector.hpp"

#include "../random_poses.hpp"
#include "cga/algebra/multivector_product.hpp"
#include "cga/algebra/product_table.hpp"
#include "cga/motor/motor_factors.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

using namespace cga;
using cga_test::Random;

namespace {

const Multivector I = *Multivector::basis("I");
const Multivector E = *Multivector::basis("E");
const Multivector EO = *Multivector::basis("eo");
const Multivector EINF = *Multivector::basis("einf");

Multivector blade(const char *name) {
	return *Multivector::basis(name);
}

// A product of two elements by its definition: parts of the geometric product, grade by grade.
template <class KeptGrade>
Multivector by_grades(const Multivector &left, const Multivector &right, KeptGrade kept_grade) {
	Multivector sum;
	for (int i = 0; i <= DIMENSION; ++i) {
		for (int j = 0; j <= DIMENSION; ++j) {
			sum += left.grade(i).geometric_product(right.grade(j)).grade(kept_grade(i, j));
		}
	}
	return sum;
}

} // namespace

TEST_CASE("basis elements") {
	CHECK(blade("e12")[6] == 1.0);
	CHECK(blade("e21")[6] == -1.0);
	CHECK(blade("1")[0] == 1.0);
	CHECK(EINF == blade("e4") + blade("e5"));
	CHECK(EO == (blade("e5") - blade("e4")) * 0.5);
	CHECK(E == blade("e45"));
	CHECK(I[31] == 1.0);
	CHECK_FALSE(Multivector::basis("e66").has_value());
	CHECK_FALSE(Multivector::basis("").has_value());
}

TEST_CASE("the conventions of the metric") {
	CHECK(EINF.inner_product(EO) == Multivector::scalar(-1.0));
	CHECK(EINF.geometric_product(EINF) == Multivector());
	CHECK(EO.geometric_product(EO) == Multivector());
	CHECK(EINF.outer_product(EO) == E);
	CHECK(E.geometric_product(E) == Multivector::scalar(1.0));
	CHECK(I.geometric_product(I) == Multivector::scalar(-1.0));
	CHECK(blade("e5").geometric_product(blade("e5")) == Multivector::scalar(-1.0));
	CHECK(blade("e12").geometric_product(blade("e2")) == blade("e1"));
	CHECK(blade("e2").geometric_product(blade("e12")) == -blade("e1"));
}

TEST_CASE("each product of random elements is its grades of the geometric product") {
	Random random(1);
	for (int repeat = 0; repeat < 200; ++repeat) {
		const Multivector a = random.multivector();
		const Multivector b = random.multivector();
		CHECK(a.outer_product(b).is_equal_approx(by_grades(a, b, [](int i, int j) { return i + j; }), 1e-13));
		CHECK(a.inner_product(b).is_equal_approx(by_grades(a, b, [](int i, int j) { return std::abs(i - j); }), 1e-13));
		CHECK(a.left_contraction(b).is_equal_approx(by_grades(a, b, [](int i, int j) { return j - i; }), 1e-13));
		CHECK(a.right_contraction(b).is_equal_approx(by_grades(a, b, [](int i, int j) { return i - j; }), 1e-13));
		CHECK(a.scalar_product(b) == doctest::Approx(a.geometric_product(b)[0]).epsilon(1e-13));
	}
}

TEST_CASE("the commutator product is (A B - B A) / 2, the regressive product the dual of the outer product of duals") {
	Random random(7);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const Multivector a = random.multivector();
		const Multivector b = random.multivector();
		const Multivector difference = a.geometric_product(b) - b.geometric_product(a);
		CHECK(a.commutator_product(b).is_equal_approx(difference * 0.5, 1e-13));
		CHECK(a.regressive_product(b).dual().is_equal_approx(a.dual().outer_product(b.dual()), 1e-13));
		const Multivector c = random.multivector();
		const Multivector left = a.regressive_product(b).regressive_product(c);
		CHECK(left.is_equal_approx(a.regressive_product(b.regressive_product(c)), 1e-12));
	}
	// I is the unit of the regressive product; the common plane of two volumes.
	const Multivector x = random.multivector();
	CHECK(I.regressive_product(x) == x);
	CHECK(x.regressive_product(I) == x);
	CHECK(blade("e1245").regressive_product(blade("e1235")) == blade("e1245").dual().outer_product(blade("e1235").dual()).undual());
	CHECK(std::abs(blade("e1245").regressive_product(blade("e1235"))[blade_index("e125")]) == 1.0);
	CHECK(blade("e12").commutator_product(blade("e2")) == blade("e1"));
	CHECK(blade("e12").commutator_product(blade("e3")) == Multivector());
}

TEST_CASE("products of motors with large translations are as precise as near the origin: e_inf e_inf cancels without rounding") {
	Random random(14);
	for (const double distance : { 1.0, 1e6, 1e12 }) {
		for (int repeat = 0; repeat < 300; ++repeat) {
			const Multivector first = translator(random.vector(distance)).geometric_product(rotor(random.rotation()));
			const Multivector second = translator(random.vector(distance)).geometric_product(rotor(random.rotation()));
			const Multivector product = first.geometric_product(second);
			CHECK(product.norm_squared() == doctest::Approx(1.0).epsilon(1e-14));
			for (const char *axis : { "1", "2", "3" }) {
				CHECK(product[blade_index(std::string("e") + axis + "4")] == product[blade_index(std::string("e") + axis + "5")]);
			}
			const double turn = product[blade_index("e12")] * product[blade_index("e12")] + product[blade_index("e13")] * product[blade_index("e13")] + product[blade_index("e23")] * product[blade_index("e23")];
			CHECK(product[0] * product[0] + turn == doctest::Approx(1.0).epsilon(1e-14));
		}
	}
}

TEST_CASE("multiplication by powers of two is exact") {
	Random random(8);
	const Multivector x = random.multivector();
	CHECK(x.times_power_of_two(0) == x);
	CHECK(x.times_power_of_two(-3) == x * 0.125);
	CHECK(x.times_power_of_two(900).times_power_of_two(-900) == x);
}

TEST_CASE("the geometric product has the same bits as the product term by term, with any instruction set") {
	Random random(14);
	for (int repeat = 0; repeat < 2000; ++repeat) {
		Multivector a = random.multivector(), b = random.multivector();
		for (int index = 0; index < BLADE_COUNT; ++index) {
			// Zeros of both signs, and sizes far apart.
			a[index] *= repeat % 3 == 0 && index % 2 == 0 ? -0.0 : std::pow(10.0, random.uniform(-8.0, 8.0));
			b[index] *= repeat % 5 == 0 && index % 3 == 0 ? 0.0 : std::pow(10.0, random.uniform(-8.0, 8.0));
		}
		const Multivector product = a.geometric_product(b), expected = multiply<Product::GEOMETRIC>(a, b);
		CHECK(std::memcmp(&product, &expected, sizeof(product)) == 0);
	}
}

TEST_CASE("the geometric product is associative and distributive") {
	Random random(2);
	for (int repeat = 0; repeat < 500; ++repeat) {
		const Multivector a = random.multivector();
		const Multivector b = random.multivector();
		const Multivector c = random.multivector();
		const Multivector left = a.geometric_product(b).geometric_product(c);
		CHECK(left.is_equal_approx(a.geometric_product(b.geometric_product(c)), 1e-12));
		CHECK(a.geometric_product(b + c).is_equal_approx(a.geometric_product(b) + a.geometric_product(c), 1e-13));
	}
}

TEST_CASE("terms outside a product have no effect, even if they would overflow") {
	const Multivector huge = blade("e1") * 1e308;
	CHECK(huge.outer_product(huge) == Multivector());
	CHECK(huge.outer_product(blade("e2"))[6] == 1e308);
	CHECK(Multivector().geometric_product(huge) == Multivector());
}

TEST_CASE("involutions by grade") {
	constexpr int REVERSE[] = { 1, 1, -1, -1, 1, 1 };
	constexpr int INVOLUTION[] = { 1, -1, 1, -1, 1, -1 };
	constexpr int CONJUGATE[] = { 1, -1, -1, 1, 1, -1 };
	for (int index = 0; index < BLADE_COUNT; ++index) {
		const Multivector x = Multivector::basis_blade(index, 3.0);
		const int k = blade_grade(index);
		CHECK(x.reverse() == x * REVERSE[k]);
		CHECK(x.grade_involution() == x * INVOLUTION[k]);
		CHECK(x.clifford_conjugate() == x * CONJUGATE[k]);
		CHECK(x.grade(k) == x);
		CHECK(x.grade((k + 1) % 6) == Multivector());
	}
	Random random(3);
	const Multivector a = random.multivector();
	const Multivector b = random.multivector();
	CHECK(a.geometric_product(b).reverse().is_equal_approx(b.reverse().geometric_product(a.reverse()), 1e-13));
	CHECK(a.grade(-1) == Multivector());
	CHECK(a.grade(6) == Multivector());
}

TEST_CASE("dual is X I^-1, and undual is its inverse") {
	CHECK(Multivector::scalar(1.0).dual() == -I);
	CHECK(I.dual() == Multivector::scalar(1.0));
	CHECK(Multivector::scalar(1.0).undual() == I);
	Random random(4);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const Multivector x = random.multivector();
		CHECK(x.dual().undual() == x);
		CHECK(x.dual().dual() == -x);
		CHECK(x.dual().geometric_product(I).is_equal_approx(x, 1e-14));
	}
}

TEST_CASE("norms") {
	CHECK(blade("e5").norm_squared() == -1.0);
	CHECK(blade("e5").norm() == 1.0);
	CHECK(EINF.norm() == 0.0);
	CHECK((blade("e12") * 3.0 + blade("e1") * 4.0).norm_squared() == 25.0);
	CHECK((blade("e123") * -7.0).max_abs() == 7.0);
	CHECK(Multivector().max_abs() == 0.0);
}

TEST_CASE("inverse of versors and blades") {
	Random random(5);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		Multivector versor = Multivector::scalar(random.scale());
		const int factors = 1 + repeat % 5;
		for (int factor = 0; factor < factors; ++factor) {
			Multivector vector = random.multivector().grade(1);
			vector[5] *= 0.1; // away from null vectors
			versor = versor.geometric_product(vector);
		}
		const auto inverse = versor.inverse_of_versor();
		REQUIRE(inverse.has_value());
		CHECK(versor.geometric_product(*inverse).is_equal_approx(Multivector::scalar(1.0), 1e-9));
		CHECK(inverse->geometric_product(versor).is_equal_approx(Multivector::scalar(1.0), 1e-9));
	}
	CHECK(*(blade("e5") * 4.0).inverse_of_versor() == blade("e5") * -0.25);
	CHECK((*(blade("e1") * 1e200).inverse_of_versor())[1] == doctest::Approx(1e-200).epsilon(1e-15));
	CHECK((*(blade("e1") * 1e-200).inverse_of_versor())[1] == doctest::Approx(1e200).epsilon(1e-15));
	CHECK((*(blade("e1") * 1e-307).inverse_of_versor())[1] == doctest::Approx(1e307).epsilon(1e-15));
	CHECK_FALSE((blade("e1") * 5e-324).inverse_of_versor().has_value());
}

TEST_CASE("null elements and elements that are not versors have no inverse_of_versor()") {
	CHECK_FALSE(Multivector().inverse_of_versor().has_value());
	CHECK_FALSE(EINF.inverse_of_versor().has_value());
	CHECK_FALSE(point({ 1000.0, 2000.0, -3000.0 }).inverse_of_versor().has_value());
	CHECK_FALSE((Multivector::scalar(1.0) + blade("e1")).inverse_of_versor().has_value());
	CHECK_FALSE((blade("e12") + blade("e34")).inverse_of_versor().has_value());
	CHECK_FALSE((blade("e1") * std::numeric_limits<double>::infinity()).inverse_of_versor().has_value());
	CHECK_FALSE((blade("e1") * std::numeric_limits<double>::quiet_NaN()).inverse_of_versor().has_value());
}

TEST_CASE("the sandwich with odd versors preserves orientation") {
	// The reflection in the plane x = 0 negates e1 and keeps e2, e23 and e_inf.
	const Multivector mirror = blade("e1") * 2.0;
	CHECK(*mirror.sandwich(blade("e1")) == -blade("e1"));
	CHECK(*mirror.sandwich(blade("e2")) == blade("e2"));
	CHECK(*mirror.sandwich(blade("e23")) == blade("e23"));
	CHECK(*mirror.sandwich(blade("e12")) == -blade("e12"));
	CHECK(*mirror.sandwich(EINF) == EINF);
	CHECK(*position_of(*mirror.sandwich(point({ 1.0, 2.0, 3.0 }))) == Vector3<double>(-1.0, 2.0, 3.0));
	// Reflections preserve scalars.
	CHECK(*mirror.sandwich(Multivector::scalar(5.0)) == Multivector::scalar(5.0));
	CHECK_FALSE((Multivector::scalar(2.0) + blade("e1")).sandwich(EO).has_value());
	CHECK_FALSE(EINF.sandwich(EO).has_value());
}

TEST_CASE("the sandwich of a product is the composition of the sandwiches, for odd versors, too") {
	Random random(6);
	for (int repeat = 0; repeat < 300; ++repeat) {
		const Multivector first = euclidean(random.vector(1.0)) + EINF * random.normal();
		const Multivector second = repeat % 2 == 0 ? rotor(random.rotation()) : euclidean(random.vector(1.0));
		const Multivector x = random.multivector();
		const Multivector together = *first.geometric_product(second).sandwich(x);
		const Multivector in_turn = *first.sandwich(*second.sandwich(x));
		CHECK(together.is_equal_approx(in_turn, 1e-10 * (1.0 + in_turn.max_abs())));
	}
}

TEST_CASE("comparison and parity") {
	const Multivector x = blade("e12") + Multivector::scalar(1.0);
	CHECK(x.is_even());
	CHECK_FALSE(x.is_odd());
	CHECK((x + blade("e1") * 1e-12).is_even());
	CHECK_FALSE((x + blade("e1") * 1e-9).is_even());
	CHECK(blade("e123").is_odd());
	CHECK(x.is_equal_approx(x + blade("e1") * 1e-10));
	CHECK_FALSE(x.is_equal_approx(x + blade("e1") * 1e-8));
	CHECK_FALSE(x.is_equal_approx(x * std::numeric_limits<double>::quiet_NaN()));
}
