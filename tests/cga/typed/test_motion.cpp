#include "cga/typed/motion.hpp"

#include "cga/motor/motor_multivector.hpp"
#include "cga/typed/objects.hpp"
#include "random_typed.hpp"

#include <doctest/doctest.h>

using namespace cga;
using namespace cga_test;

namespace {

constexpr int CASES = 2000;

Motor<double> random_motor(Random &random) {
	const Motor<double> unit = Motor<double>::from_pose({ random.vector(3.0), random.rotation(), random.uniform(0.5, 2.0) });
	const double weight = random.uniform(0.1, 3.0) * (random.uniform(0.0, 1.0) < 0.5 ? 1.0 : -1.0);
	return { unit.a * weight, unit.b * weight, unit.v * weight };
}

template <class Element>
void check_moved(Random &random) {
	for (int repeat = 0; repeat < CASES; ++repeat) {
		const Motor<double> motor = random_motor(random);
		const Element x = random_element<Element>(random);
		const std::optional<Multivector> wanted = to_multivector(motor).sandwich(x.to_multivector());
		REQUIRE(wanted);
		CHECK(difference(typed::moved(x, motor), *wanted) < 1e-11);
	}
}

} // namespace

TEST_CASE("a motor moves each type as its multivector does") {
	Random random(81);
	check_moved<typed::Point<>>(random);
	check_moved<typed::PointPair<>>(random);
	check_moved<typed::Circle<>>(random);
	check_moved<typed::Sphere<>>(random);
	check_moved<typed::FlatPoint<>>(random);
	check_moved<typed::Line<>>(random);
	check_moved<typed::Plane<>>(random);
}

TEST_CASE("the twelve coefficients are those of the motor's multivector, and products stay within them") {
	Random random(82);
	for (int repeat = 0; repeat < CASES; ++repeat) {
		const Motor<double> first = random_motor(random), second = random_motor(random);
		CHECK(difference(typed::versor(first), to_multivector(first)) < 1e-15);
		CHECK(difference(typed::versor(first).geometric_product(typed::versor(second)), to_multivector(compose(first, second))) < 1e-13);
	}
}

TEST_CASE("the pose maps a sphere's center and scales its radius") {
	Random random(83);
	for (int repeat = 0; repeat < CASES; ++repeat) {
		const PoseD pose{ random.vector(3.0), random.rotation(), random.uniform(0.5, 2.0) };
		const Vector3D p = random.vector(3.0);
		const double radius = random.uniform(0.5, 2.0);
		const typed::Sphere<> image = typed::moved(typed::sphere(p, radius), Motor<double>::from_pose(pose));
		CHECK(glm::length(typed::center(image) - transformed(pose, p)) < 1e-12);
		CHECK(std::sqrt(typed::squared_radius(image)) == doctest::Approx(radius * pose.scale).epsilon(1e-10));
	}
}

TEST_CASE("is_closed_under_motors() is true for the types that motors preserve") {
	CHECK(typed::is_closed_under_motors(typed::Line<>::BLADES));
	CHECK(typed::is_closed_under_motors(typed::Plane<>().dual().BLADES));
	CHECK(typed::is_closed_under_motors(typed::MOTOR_BLADES));
	CHECK_FALSE(typed::is_closed_under_motors(typed::BladeSet(1) << E1));
	CHECK_FALSE(typed::is_closed_under_motors(typed::BladeSet(1) << E5));
	CHECK_FALSE(typed::is_closed_under_motors(typed::BladeSet(1) << E123));
}
