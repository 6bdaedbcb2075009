#include "cga/algebra/is_blade.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/versor/exponential.hpp"
#include "cga/versor/inverse.hpp"
#include "cga/versor/is_versor.hpp"
#include "cga/versor/logarithm.hpp"
#include "cga/versor/normalized.hpp"
#include "cga/versor/power.hpp"
#include "random_versors.hpp"

#include <doctest/doctest.h>

#include <string>

// No finite input gives NaN or infinity without an error, whatever the sizes of its coefficients.

using namespace cga;
using namespace cga_test;

namespace {

const double SIZES[] = { 5e-324, 1e-310, 1e-300, 1e-160, 1e-100, 1e-20, 1e-8, 1e-3, 1.0, 1.0, 1.0, 1e3, 1e8, 1e20, 1e100, 1e155, 1e300, 1.7e308 };

double random_size(Random &random) {
	const double size = SIZES[size_t(random.uniform(0.0, 18.0))];
	return random.uniform(0.0, 1.0) < 0.5 ? -size : size;
}

// A few coefficients of very different sizes.
Multivector random_extremes(Random &random, int begin, int end) {
	Multivector x;
	for (int count = 1 + int(random.uniform(0.0, 5.0)); count > 0; --count) {
		x[begin + int(random.uniform(0.0, end - begin))] = random_size(random);
	}
	return x;
}

Multivector random_motor(Random &random) {
	const PoseD pose{ random.vector(random_size(random)), random.rotation(), std::abs(random_size(random)) };
	return to_multivector(Motor<double>::from_pose(pose)) * random_size(random);
}

void check(const char *name, const MultivectorResult &result) {
	const bool sound = result ? result->is_finite() : !std::string(describe(result.error())).empty();
	CHECK_MESSAGE(sound, name);
}

} // namespace

TEST_CASE("every function of any finite element is finite or an error") {
	Random random(161);
	for (int repeat = 0; repeat < 20000; ++repeat) {
		Multivector x;
		switch (repeat % 4) {
			case 0:
				x = random_extremes(random, 0, BLADE_COUNT);
				break;
			case 1:
				x = random_extremes(random, blade_index("e12"), blade_index("e123"));
				break;
			case 2:
				x = (random.multivector() + random.multivector().grade_involution()) * random_size(random);
				break;
			default:
				x = random_motor(random);
		}
		if (!x.is_finite()) {
			continue;
		}
		check("inverse", inverse(x));
		check("normalized", normalized(x));
		check("exp", exp(x));
		check("log", log(x));
		check("sqrt", cga::sqrt(x));
		check("power", power(x, random.uniform(-1000.0, 1000.0)));
		check("whole power", power(x, std::round(random.uniform(-9.0, 9.0))));
		// Predicates must not crash; the dual of a blade is a blade.
		CHECK(is_blade(x) == is_blade(x.dual()));
		CHECK((is_versor(x) || !is_motor(x, 1e-10)));
	}
}
