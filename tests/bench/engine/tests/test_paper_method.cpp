#include "../../../cga/random_poses.hpp"
#include "../paper_method.hpp"

#include "cga/algebra/multivector.hpp"
#include "cga/motor/interpolate.hpp"

#include <doctest/doctest.h>

using namespace bench::paper;
using cga_test::Random;

namespace {

Element element_of(const cga::Multivector &multivector) {
	Element element;
	for (int index = 0; index < cga::BLADE_COUNT; ++index) {
		element[size_t(index)] = float(multivector[index]);
	}
	return element;
}

void check_near(const Element &element, const cga::Multivector &expected) {
	for (int index = 0; index < cga::BLADE_COUNT; ++index) {
		CHECK(double(element[size_t(index)]) == doctest::Approx(expected[index]).epsilon(1e-4).scale(10.0));
	}
}

} // namespace

TEST_CASE("the products of the paper have as many terms as it states and equal those of src/cga") {
	CHECK(term_count(cga::Product::GEOMETRIC) == 1024);
	CHECK(term_count(cga::Product::INNER) == 454);
	Random random(1);
	for (int i = 0; i < 20; ++i) {
		const cga::Multivector left = random.multivector();
		const cga::Multivector right = random.multivector();
		Element result;
		geometric_product(element_of(left), element_of(right), result);
		check_near(result, left.geometric_product(right));
		inner_product(element_of(left), element_of(right), result);
		check_near(result, left.inner_product(right));
		conjugate(element_of(left), result);
		check_near(result, left.clifford_conjugate());
	}
}

TEST_CASE("the method of the paper gives the linear blend with either store") {
	Random random(2);
	Pool pool;
	Allocating allocating;
	for (int i = 0; i < 200; ++i) {
		const cga::Pose<float> from = cga::pose_cast<float>(random.pose());
		const cga::Pose<float> to = cga::pose_cast<float>(random.pose());
		const float weight = float(random.uniform(0.0, 1.0));
		const Ends ends(from, to);
		const cga_test::PoseD expected = cga::pose_cast<double>(cga::interpolate(from, to, weight, cga::Mode::LINEAR));
		const cga::Pose<float> pooled = interpolate(ends, weight, pool);
		CHECK(cga_test::difference(cga::pose_cast<double>(pooled), expected) < 2e-5);
		const cga::Pose<float> allocated = interpolate(ends, weight, allocating);
		CHECK(allocated.translation == pooled.translation);
		CHECK(allocated.rotation == pooled.rotation);
		CHECK(allocated.scale == pooled.scale);
	}
}

TEST_CASE("the method of the paper acquires 14 multivectors per pose, and its pool zeroes released ones") {
	Random random(3);
	Pool pool;
	const Ends ends(cga::pose_cast<float>(random.pose()), cga::pose_cast<float>(random.pose()));
	(void)interpolate(ends, 0.25f, pool);
	CHECK(pool.acquired() == 14);
	Element *element = pool.acquire();
	CHECK((*element)[0] == 0.0f);
	(*element)[5] = 3.0f;
	pool.release(element);
	for (int i = 0; i < 20; ++i) {
		CHECK((*pool.acquire())[5] == 0.0f);
	}
}
