#include "playground/object_incidence.hpp"

#include "../cga/random_poses.hpp"
#include "cga/algebra/is_blade.hpp"
#include "playground/object_shapes.hpp"

#include <doctest/doctest.h>

using namespace playground;
using cga::Multivector;
using cga_test::Random;

namespace {

// An object of a kind 0..6 near the origin.
Multivector object(Random &random, int kind) {
	const Location a = random.vector(1.0);
	const Location b = random.vector(1.0);
	const double radius = random.uniform(0.5, 2.0);
	const Shape shapes[] = { point_pair(a, b), line(a, b), circle(a, b, radius), plane(a, radius), sphere(a, radius), flat_point(a), point_pair(a, a + b * 0.1) };
	return *shapes[kind];
}

// The same but for a factor.
bool is_same_subspace(const Multivector &left, const Multivector &right) {
	const Multivector a = left * (1.0 / left.max_abs());
	const Multivector b = right * (1.0 / right.max_abs());
	return a.is_equal_approx(b, 1e-7) || a.is_equal_approx(-b, 1e-7);
}

} // namespace

TEST_CASE("the meet lies in both, the join contains both, whatever the objects are") {
	Random random(1);
	for (int repeat = 0; repeat < 2000; ++repeat) {
		const Multivector a = object(random, repeat % 7);
		const Multivector b = object(random, repeat / 7 % 7);
		const Multivector meeting = *meet(a, b);
		const Multivector joined = *join(a, b);
		REQUIRE(cga::is_blade(meeting, 1e-8));
		REQUIRE(cga::is_blade(joined, 1e-8));
		const int grade = *cga::single_grade(meeting, 1e-8);
		CHECK(grade + *cga::single_grade(joined, 1e-8) == *cga::single_grade(a) + *cga::single_grade(b));
		if (grade > 0) {
			CHECK(is_same_subspace(*join(meeting, a), a));
			CHECK(is_same_subspace(*join(meeting, b), b));
		}
		CHECK(is_same_subspace(*join(joined, a), joined));
		CHECK(is_same_subspace(*join(joined, b), joined));
	}
}

TEST_CASE("degenerate positions") {
	const Location origin(0.0);
	const Location x(1.0, 0.0, 0.0);
	const Location y(0.0, 1.0, 0.0);
	const Location z(0.0, 0.0, 1.0);
	const Multivector along_x = *line(origin, x);
	const auto grade_of_meet = [](const Multivector &a, const Multivector &b) { return *cga::single_grade(*meet(a, b)); };
	CHECK(grade_of_meet(along_x, *line(origin, y)) == 2); // crossing lines: a flat point
	CHECK(is_same_subspace(*meet(along_x, *line(origin, y)), *flat_point(origin)));
	CHECK(grade_of_meet(along_x, *line(z, y)) == 1); // skew lines: the point at infinity alone
	CHECK(grade_of_meet(along_x, *line(z, x)) == 2); // parallel lines: their direction
	CHECK(is_same_subspace(*meet(along_x, *line(z, x)), (*Multivector::basis("e1")).outer_product(*Multivector::basis("einf"))));
	CHECK(*meet(along_x, along_x) * (1.0 / meet(along_x, along_x)->max_abs()) == along_x * (1.0 / along_x.max_abs()));
	CHECK(is_same_subspace(*meet(along_x, *plane(z, 0.0)), along_x)); // a line in a plane
	CHECK(grade_of_meet(along_x, *plane(z, 1.0)) == 2); // beside it: their direction
	CHECK(grade_of_meet(*plane(z, 0.0), *plane(z, 1.0)) == 3); // parallel planes: their common directions
	CHECK(grade_of_meet(*circle(origin, z, 1.0), *circle(origin, z, 2.0)) == 2); // concentric circles: an imaginary pair
	CHECK(grade_of_meet(*circle(origin, z, 1.0), *circle(x, z, 1.0)) == 2); // crossing circles of a plane: a pair
	CHECK(grade_of_meet(*sphere(origin, 1.0), *sphere(origin, 2.0)) == 3); // concentric spheres: an imaginary circle
	CHECK(grade_of_meet(*sphere(origin, 1.0), *plane(z, 1.0)) == 3); // touching: a tangent
	CHECK(is_same_subspace(*join(*point_pair(origin, x), *point_pair(x, y)), *circle_through(origin, x, y)));
}

TEST_CASE("projection and rejection make up the whole; reflecting twice changes nothing") {
	Random random(2);
	for (int repeat = 0; repeat < 500; ++repeat) {
		const Multivector x = object(random, repeat % 7);
		const Multivector mirror = object(random, 1 + repeat / 7 % 4);
		CHECK((*project_onto(x, mirror) + *reject_from(x, mirror)).is_equal_approx(x, 1e-9 * x.max_abs()));
		const Multivector twice = *reflect_in(*reflect_in(x, mirror), mirror);
		CHECK(twice.is_equal_approx(x, 1e-7 * (1.0 + x.max_abs())));
	}
	const Multivector onto = *plane(Location(0.0, 0.0, 1.0), 2.0);
	const Multivector projected = *project_onto(*line(Location(0.0), Location(1.0, 0.0, 1.0)), onto);
	CHECK(is_same_subspace(projected, *line(Location(0.0, 0.0, 2.0), Location(1.0, 0.0, 0.0))));
}
