#include "cga/motor/interpolate.hpp"

#include "../random_poses.hpp"
#include "cga/motor/motor_exp.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <utility>
#include <vector>

using namespace cga;
using namespace cga_test;

namespace {

constexpr Mode MODES[] = { Mode::LINEAR, Mode::SCREW, Mode::SEPARATE };

PoseD opposite(const PoseD &pose) {
	return { pose.translation, -pose.rotation, pose.scale };
}

// The definition: lerp the coefficients of the unit-weight TR_1 and TR_2 with 1 - a and copysign(a, q1 . q2), extract, blend
// the scale separately.
PoseD paper_blend(const PoseD &from, const PoseD &to, double weight) {
	const auto first = Motor<double>::from_pose({ from.translation, from.rotation, 1.0 });
	const auto second = Motor<double>::from_pose({ to.translation, to.rotation, 1.0 });
	const double signed_weight = std::copysign(weight, glm::dot(from.rotation, to.rotation));
	Motor<double> blend;
	blend.a = first.a * (1.0 - weight) + second.a * signed_weight;
	blend.b = first.b * (1.0 - weight) + second.b * signed_weight;
	blend.v = first.v * (1.0 - weight) + second.v * signed_weight;
	PoseD pose = *blend.to_pose();
	pose.scale = from.scale * (1.0 - weight) + to.scale * weight;
	return pose;
}

// The screw by multiplying motors: M_1 (M_1^-1 M_2)^a.
PoseD screw_by_motors(const PoseD &from, const PoseD &to, double weight) {
	const auto first = Motor<double>::from_pose(from);
	const auto second = Motor<double>::from_pose(to);
	return *compose(first, *power(compose(*first.inverse(), second), weight)).to_pose();
}

PoseD separate_by_glm(const PoseD &from, const PoseD &to, double weight) {
	return { glm::mix(from.translation, to.translation, weight), glm::slerp(from.rotation, to.rotation, weight), glm::mix(from.scale, to.scale, weight) };
}

} // namespace

TEST_CASE("each mode agrees with its definition") {
	Random random(41);
	for (int repeat = 0; repeat < 5000; ++repeat) {
		const PoseD from = random.pose();
		const PoseD to = random.pose();
		const double weight = random.uniform(0.0, 1.0);
		CHECK(difference(interpolate(from, to, weight, Mode::LINEAR), paper_blend(from, to, weight)) < 1e-13);
		CHECK(difference(interpolate(from, to, weight, Mode::SCREW), screw_by_motors(from, to, weight)) < 1e-11);
		CHECK(difference(interpolate(from, to, weight, Mode::SEPARATE), separate_by_glm(from, to, weight)) < 1e-13);
	}
}

TEST_CASE("weights 0 and 1 return the poses bit for bit") {
	Random random(42);
	for (int repeat = 0; repeat < 500; ++repeat) {
		const Pose<float> from = pose_cast<float>(random.pose());
		const Pose<float> to = pose_cast<float>(random.pose());
		for (const Mode mode : MODES) {
			for (const float weight : { 0.0f, 1.0f }) {
				const Pose<float> end = interpolate(from, to, weight, mode);
				const Pose<float> &expected = weight == 0.0f ? from : to;
				CHECK(end.translation == expected.translation);
				CHECK(end.rotation == expected.rotation);
				CHECK(end.scale == expected.scale);
			}
		}
	}
}

TEST_CASE("the path is continuous at its ends") {
	Random random(43);
	for (int repeat = 0; repeat < 500; ++repeat) {
		const PoseD from = random.pose();
		const PoseD to = random.pose();
		for (const Mode mode : MODES) {
			CHECK(difference(interpolate(from, to, 1e-12, mode), from) < 1e-7);
			CHECK(difference(interpolate(from, to, 1.0 - 1e-12, mode), to) < 1e-7);
		}
	}
}

TEST_CASE("paths are symmetric, and q and -q give the same one") {
	Random random(44);
	for (int repeat = 0; repeat < 2000; ++repeat) {
		const PoseD from = random.pose();
		const PoseD to = random.pose();
		const double weight = random.uniform(0.0, 1.0);
		for (const Mode mode : MODES) {
			const PoseD pose = interpolate(from, to, weight, mode);
			CHECK(difference(pose, interpolate(to, from, 1.0 - weight, mode)) < 1e-12);
			CHECK(difference(pose, interpolate(opposite(from), to, weight, mode)) < 1e-14);
			CHECK(difference(pose, interpolate(from, opposite(to), weight, mode)) < 1e-14);
		}
	}
}

TEST_CASE("the path does not depend on where the world's origin is") {
	Random random(45);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const PoseD from = random.pose();
		const PoseD to = random.pose();
		const PoseD frame = random.pose(1.0);
		const auto moved = [&frame](const PoseD &pose) -> PoseD {
			return { transformed(frame, pose.translation), frame.rotation * pose.rotation, frame.scale * pose.scale };
		};
		for (const Mode mode : MODES) {
			const PoseD pose = interpolate(from, to, 0.3, mode);
			CHECK(difference(interpolate(moved(from), moved(to), 0.3, mode), moved(pose)) < 1e-12);
		}
	}
}

TEST_CASE("ten kilometers from the origin, a step of a meter is as precise as float positions") {
	Random random(46);
	for (int repeat = 0; repeat < 2000; ++repeat) {
		Pose<float> from = pose_cast<float>(random.rigid_pose(1e4));
		Pose<float> to = pose_cast<float>(random.rigid_pose(1.0));
		to.translation += from.translation;
		const float weight = float(random.uniform(0.0, 1.0));
		for (const Mode mode : MODES) {
			const PoseD exact = interpolate(pose_cast<double>(from), pose_cast<double>(to), double(weight), mode);
			const Pose<float> pose = interpolate(from, to, weight, mode);
			for (int axis = 0; axis < 3; ++axis) {
				const float rounded = float(exact.translation[axis]);
				CHECK(std::abs(pose.translation[axis] - rounded) <= std::abs(rounded) * 1.2e-7f);
			}
		}
	}
}

TEST_CASE("linear deviates from the screw by at most 8.2 degrees at 180, 0.9 at 90, 0.03 at 30") {
	const double degrees[] = { 180.0, 90.0, 30.0 };
	const double bounds[] = { 8.2, 0.92, 0.034 };
	for (int i = 0; i < 3; ++i) {
		const PoseD from;
		const PoseD to{ Vector3D(0.0), axis_angle({ 1.0, 2.0, -1.0 }, degrees[i] * PI / 180.0), 1.0 };
		double worst = 0.0;
		for (double weight = 0.0; weight <= 1.0; weight += 1.0 / 512.0) {
			const PoseD linear = interpolate(from, to, weight, Mode::LINEAR);
			const PoseD screw = interpolate(from, to, weight, Mode::SCREW);
			worst = std::max(worst, angle_between(linear.rotation, screw.rotation) * 180.0 / PI);
		}
		CAPTURE(degrees[i]);
		CHECK(worst < bounds[i]);
		CHECK(worst > 0.97 * bounds[i]);
	}
}

TEST_CASE("the screw has constant speed in angle, distance and the logarithm of scale, also outside 0..1") {
	const PoseD from{ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0, 0.0 }, 1.0 };
	const PoseD to{ { 0.0, 0.0, 3.0 }, axis_angle({ 0.0, 0.0, 1.0 }, 1.0), 1.0 };
	for (const double weight : { -1.0, -0.25, 0.25, 0.5, 0.75, 2.0 }) {
		const PoseD pose = interpolate(from, to, weight, Mode::SCREW);
		CHECK(pose.translation.z == doctest::Approx(3.0 * weight).epsilon(1e-14));
		CHECK(angle_between(pose.rotation, axis_angle({ 0.0, 0.0, 1.0 }, weight)) < 1e-14);
		const PoseD grown = interpolate(from, { to.translation, to.rotation, 4.0 }, weight, Mode::SCREW);
		CHECK(grown.scale == doctest::Approx(std::pow(4.0, weight)).epsilon(1e-14));
	}
	for (const Mode mode : { Mode::LINEAR, Mode::SEPARATE }) {
		CHECK(difference(interpolate(from, to, -0.5, mode), from) == 0.0);
		CHECK(difference(interpolate(from, to, 1.5, mode), to) == 0.0);
	}
}

TEST_CASE("the paper's midpoint of scales 1 and 4 is at the middle") {
	const PoseD from{ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0, 0.0 }, 1.0 };
	const PoseD to{ { 6.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0, 0.0 }, 4.0 };
	const PoseD linear = interpolate(from, to, 0.5, Mode::LINEAR);
	CHECK(linear.translation.x == 3.0);
	CHECK(linear.scale == 2.5);
	CHECK(interpolate(from, to, 0.5, Mode::SEPARATE).scale == 2.5);
	// The screw's center is where both map a point to itself, at x = -2: 2 becomes 4 and then 8.
	const PoseD screw = interpolate(from, to, 0.5, Mode::SCREW);
	CHECK(screw.translation.x == doctest::Approx(2.0).epsilon(1e-14));
	CHECK(screw.scale == doctest::Approx(2.0).epsilon(1e-14));
}

TEST_CASE("a rotation by pi takes one of the two directions, at constant speed") {
	const PoseD from{ { 1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0, 0.0 }, 1.0 };
	for (const QuaternionD &half_turn : { QuaternionD(0.0, 0.0, 0.0, 1.0), QuaternionD(0.0, 0.0, 0.0, -1.0), QuaternionD(-0.0, 0.0, 0.0, 1.0) }) {
		const PoseD to{ { -1.0, 0.0, 0.0 }, half_turn, 1.0 };
		for (const Mode mode : MODES) {
			const PoseD middle = interpolate(from, to, 0.5, mode);
			CHECK(angle_between(middle.rotation, from.rotation) == doctest::Approx(PI / 2.0).epsilon(1e-14));
			CHECK(angle_between(middle.rotation, to.rotation) == doctest::Approx(PI / 2.0).epsilon(1e-14));
			CHECK(glm::length(middle.translation) == doctest::Approx(mode == Mode::SEPARATE ? 0.0 : 1.0).epsilon(1e-14));
		}
	}
}

TEST_CASE("rotations are normalized; a zero one counts as the identity") {
	const QuaternionD turn = axis_angle({ 1.0, 1.0, 0.0 }, 1.0);
	const PoseD from{ { 1.0, 2.0, 3.0 }, turn, 1.0 };
	const PoseD to{ { 3.0, 2.0, 1.0 }, { 1.0, 0.0, 0.0, 0.0 }, 2.0 };
	for (const Mode mode : MODES) {
		const PoseD expected = interpolate(from, to, 0.4, mode);
		for (const double factor : { 1e-300, 1e-5, 7.0, 1e300 }) {
			const PoseD stretched{ from.translation, turn * factor, from.scale };
			CHECK(difference(interpolate(stretched, to, 0.4, mode), expected) < 1e-14);
			CHECK(std::abs(glm::length(interpolate(stretched, to, 0.0, mode).rotation) - 1.0) < 1e-15);
		}
		const PoseD nothing{ to.translation, { 0.0, 0.0, 0.0, 0.0 }, to.scale };
		CHECK(difference(interpolate(from, nothing, 0.4, mode), expected) < 1e-14);
	}
}

TEST_CASE_TEMPLATE("finite input gives a finite pose of unit rotation", T, float, double) {
	const T huge = T(1e30);
	const T largest = std::numeric_limits<T>::max();
	const T denormal = std::numeric_limits<T>::denorm_min();
	const T lengths[] = { T(0), T(1), -huge, largest, -largest, denormal };
	const T scales[] = { T(1), T(0.01), T(100), denormal, largest, T(0), T(-1) };
	std::vector<Pose<T>> poses;
	for (const T length : lengths) {
		for (const T scale : scales) {
			for (const Quaternion<T> &rotation : { Quaternion<T>(T(1), T(0), T(0), T(0)), Quaternion<T>(T(-1), T(0), T(0), T(0)), Quaternion<T>(T(0), T(0), T(1), T(0)), Quaternion<T>(T(1), denormal, T(0), T(0)), Quaternion<T>(T(0), T(0), T(0), T(0)), Quaternion<T>(huge, largest, T(0), -largest), Quaternion<T>(T(1), T(1e-7), T(-1e-9), T(0)) }) {
				poses.push_back({ { length, T(1), -length }, rotation, scale });
			}
		}
	}
	int bad = 0;
	int not_unit = 0;
	for (const Pose<T> &from : poses) {
		for (const Pose<T> &to : poses) {
			for (const Mode mode : MODES) {
				for (const T weight : { T(0), T(0.5), T(1), T(0.999999), denormal, T(-3), T(40), T(-1e30), largest }) {
					const Pose<T> pose = interpolate(from, to, weight, mode);
					bad += cga_test::is_finite(pose) ? 0 : 1;
					not_unit += std::abs(glm::dot(pose.rotation, pose.rotation) - T(1)) < T(1e-6) ? 0 : 1;
				}
			}
		}
	}
	CHECK(poses.size() == 294);
	CHECK(bad == 0);
	CHECK(not_unit == 0);
}

TEST_CASE("between the smallest and the largest scale of float, the middle is the geometric mean") {
	const Pose<float> from{ { 0.0f, 0.0f, 0.0f }, { 1.0f, 0.0f, 0.0f, 0.0f }, 1e-30f };
	const Pose<float> to{ { 8.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 1.0f, 0.0f }, 1e30f };
	for (const auto &ends : { std::pair(from, to), std::pair(to, from) }) {
		const Pose<float> middle = interpolate(ends.first, ends.second, 0.5f, Mode::SCREW);
		CHECK(middle.scale == doctest::Approx(1.0).epsilon(1e-6));
		CHECK(middle.translation.x == doctest::Approx(0.0).epsilon(1e-6)); // nearly the whole displacement is near the larger end
		CHECK(angle_between(pose_cast<double>(middle).rotation, QuaternionD(1.0, 0.0, 0.0, 0.0)) == doctest::Approx(PI / 2.0).epsilon(1e-6));
	}
	// A ratio beyond the range of double gives the nearer end.
	const PoseD tiny{ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0, 0.0 }, 1e-200 };
	const PoseD vast{ { 8.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0, 0.0 }, 1e200 };
	CHECK(interpolate(tiny, vast, 0.4, Mode::SCREW).scale == 1e-200);
	CHECK(interpolate(tiny, vast, 0.6, Mode::SCREW).scale == 1e200);
}

TEST_CASE("a scale that is not positive is lerped, and the motion is the rigid screw") {
	const PoseD from{ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0, 0.0 }, 2.0 };
	const PoseD to{ { 4.0, 0.0, 0.0 }, axis_angle({ 1.0, 0.0, 0.0 }, 1.0), 0.0 };
	const PoseD pose = interpolate(from, to, 0.25, Mode::SCREW);
	CHECK(pose.scale == 1.5);
	CHECK(pose.translation.x == doctest::Approx(1.0).epsilon(1e-14));
	CHECK(angle_between(pose.rotation, axis_angle({ 1.0, 0.0, 0.0 }, 0.25)) < 1e-15);
}
