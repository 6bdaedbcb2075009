#include "net/coding/portable_math.hpp"

#include "../../cga/random_poses.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace net;

TEST_CASE("portable math: log2 and exp2 agree with the C library to the last bits") {
	cga_test::Random random(31);
	for (int i = 0; i < 20000; ++i) {
		const double x = random.uniform(-16.0, 16.0);
		CHECK(std::fabs(portable_exp2(x) / std::exp2(x) - 1.0) < 1e-15);
		const double scale = std::exp2(x);
		CHECK(std::fabs(portable_log2(scale) - std::log2(scale)) <= 4e-16 + 4e-16 * std::fabs(x));
	}
}

TEST_CASE("portable math: powers of 2 are exact, and exp2 inverts log2") {
	for (int i = -300; i <= 300; ++i) {
		CHECK(portable_exp2(double(i)) == std::ldexp(1.0, i));
		CHECK(portable_log2(std::ldexp(1.0, i)) == double(i));
	}
	for (int level = -65536; level <= 65536; level += 7) {
		CHECK(std::round(portable_log2(portable_exp2(level / 4096.0)) * 4096.0) == double(level));
	}
}
