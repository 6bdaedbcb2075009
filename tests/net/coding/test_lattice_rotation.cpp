#include "net/coding/lattice_rotation.hpp"

#include "../../cga/random_poses.hpp"

#include <doctest/doctest.h>

#include <iterator>

using namespace net;
using cga_test::QuaternionD;

namespace {

bool is_same(const LatticeRotation &a, const LatticeRotation &b) {
	return a.dropped == b.dropped && std::equal(std::begin(a.level), std::end(a.level), std::begin(b.level));
}

} // namespace

TEST_CASE("lattice rotation: within 3/2 steps of every rotation, of unit length") {
	cga_test::Random random(31);
	double worst = 0.0;
	double max_deviation = 0.0;
	for (int i = 0; i < 50000; ++i) {
		const QuaternionD q = random.rotation();
		const LatticeRotation lattice = LatticeRotation::nearest(q);
		REQUIRE(lattice.is_valid());
		worst = std::max(worst, cga_test::angle_between(q, lattice.value()));
		max_deviation = std::max(max_deviation, std::abs(glm::length(lattice.value()) - 1.0));
	}
	// The error is half a step in three components and up to 3/2 in the fourth: sqrt(3) steps of the quaternion, twice that in angle.
	CHECK(worst < 2.0 * std::sqrt(3.0) / LatticeRotation::STEPS);
	CHECK(worst > 1.0 / LatticeRotation::STEPS);
	CHECK(max_deviation < 1e-15);
}

TEST_CASE("lattice rotation: its own value is nearest to itself, so that states do not drift") {
	cga_test::Random random(32);
	int moved = 0;
	for (int i = 0; i < 50000; ++i) {
		const LatticeRotation lattice = LatticeRotation::nearest(random.rotation());
		moved += is_same(LatticeRotation::nearest(lattice.value()), lattice) ? 0 : 1;
	}
	// Where the two largest components are nearly equal, another one may be dropped: the rotation stays the same.
	CHECK(moved < 25);
	for (const QuaternionD &q : { QuaternionD(1, 0, 0, 0), QuaternionD(0, 1, 0, 0), QuaternionD(0, 0, 1, 0), QuaternionD(0, 0, 0, 1) }) {
		CHECK(LatticeRotation::nearest(q).value() == q);
		CHECK(LatticeRotation::nearest(-q).value() == q);
	}
}

TEST_CASE("lattice rotation: q and -q are the same") {
	cga_test::Random random(33);
	for (int i = 0; i < 2000; ++i) {
		const QuaternionD q = random.rotation();
		// Halves are rounded up, so only exact halves could differ, which random components are not.
		CHECK(is_same(LatticeRotation::nearest(q), LatticeRotation::nearest(-q)));
	}
}

TEST_CASE("lattice rotation: components that no unit quaternion has are rejected") {
	struct Row {
		LatticeRotation lattice;
		bool valid;
	};
	const int32_t max = LatticeRotation::MAX_LEVEL;
	for (const Row &row : {
				 Row{ { 3, { 0, 0, 0 } }, true },
				 Row{ { 0, { max, 0, 0 } }, true },
				 Row{ { 0, { max + 1, 0, 0 } }, false },
				 Row{ { 0, { 0, 0, -max - 1 } }, false },
				 Row{ { 4, { 0, 0, 0 } }, false },
				 Row{ { 255, { 0, 0, 0 } }, false },
				 Row{ { 1, { max, max, 0 } }, false },
				 Row{ { 2, { max, max, max } }, false },
				 Row{ { 2, { 75000, 75000, 75000 } }, true },
				 Row{ { 2, { 75700, 75700, 75700 } }, false },
		 }) {
		CAPTURE(int(row.lattice.dropped));
		CAPTURE(row.lattice.level[0]);
		CHECK(row.lattice.is_valid() == row.valid);
	}
	// A level fits its bits.
	CHECK(max < (1 << (LatticeRotation::BITS - 1)));
	const QuaternionD diagonal(std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0);
	CHECK(LatticeRotation::nearest(diagonal).is_valid());
}
