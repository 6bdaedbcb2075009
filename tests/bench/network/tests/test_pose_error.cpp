#include "../method_result.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace bench;

namespace {

using Pose = cga::Pose<double>;

Pose at(double x, double y, double z) {
	Pose pose;
	pose.translation = { x, y, z };
	return pose;
}

Pose turned(double degrees, const glm::dvec3 &axis) {
	Pose pose;
	pose.rotation = glm::angleAxis(glm::radians(degrees), axis);
	return pose;
}

TraceBody body_of(const std::vector<double> &times, const std::vector<Pose> &poses) {
	TraceBody body;
	for (size_t i = 0; i < times.size(); ++i) {
		body.samples.push_back({ times[i], poses[i] });
	}
	return body;
}

} // namespace

TEST_CASE("pose error: known distances") {
	CHECK(lever_distance(at(1, 2, 3), at(1, 2, 3)) == 0.0);
	CHECK(lever_distance(at(1, 2, 3), at(1, 5, 7)) == doctest::Approx(5.0));
	// A rotation about z moves the points at the lever arm on x and y by a chord: 2 * 0.25 sin(angle / 2).
	for (const double degrees : { 0.01, 1.0, 90.0, 180.0 }) {
		const double chord = 0.5 * std::sin(glm::radians(degrees) / 2.0);
		CHECK(lever_distance(Pose(), turned(degrees, { 0, 0, 1 })) == doctest::Approx(chord));
	}
	// About (1, 1, 1) the points at the lever arm are closer to the axis, by sqrt(2/3).
	CHECK(lever_distance(Pose(), turned(90, glm::normalize(glm::dvec3(1)))) == doctest::Approx(0.5 * std::sqrt(2.0 / 3.0) * std::sin(glm::radians(45.0))));
	// A rotation about z and a translation along y add up at the point at the lever arm on x; there is none on -x.
	Pose both = turned(2.0, { 0, 0, 1 });
	both.translation.y = 0.25 * std::sin(glm::radians(2.0));
	CHECK(lever_distance(Pose(), both) == doctest::Approx(0.5 * std::sin(glm::radians(2.0))).epsilon(1e-3));
	// q and -q are the same rotation; scale moves the points at the lever arm, not the center.
	Pose negative = turned(40, { 0, 1, 0 });
	negative.rotation = -negative.rotation;
	CHECK(lever_distance(turned(40, { 0, 1, 0 }), negative) == doctest::Approx(0.0));
	Pose large;
	large.scale = 1.2;
	CHECK(lever_distance(Pose(), large) == doctest::Approx(0.05));
	// Symmetric.
	CHECK(lever_distance(both, large) == doctest::Approx(lever_distance(large, both)));
}

TEST_CASE("pose error: a NaN is never a small error") {
	const double nan = std::nan("");
	Pose broken;
	broken.rotation.x = nan;
	CHECK(std::isnan(lever_distance(Pose(), broken)));
	CHECK(std::isnan(lever_distance(at(nan, 0, 0), Pose())));
	ErrorSummary summary;
	summary.add(nan, Motion::MOVING);
	summary.add(0.001, Motion::MOVING);
	CHECK(std::isinf(summary.figures().max));
	CHECK(std::isinf(summary.figures().p99));
}

TEST_CASE("pose error: a body moves if its center or a point at the lever arm is faster than 1 mm/s") {
	const auto moves = [](const Pose &pose, double seconds) { return find_motion(body_of({ 0, seconds }, { Pose(), pose }))[1] == Motion::MOVING; };
	CHECK(moves(at(0.0011, 0, 0), 1.0));
	CHECK_FALSE(moves(at(0.0009, 0, 0), 1.0));
	CHECK(moves(at(0.0009, 0, 0), 0.5));
	// 0.25 m times the angle: 1 mm at 0.2292 degrees.
	CHECK(moves(turned(0.23, { 0, 0, 1 }), 1.0));
	CHECK_FALSE(moves(turned(0.228, { 0, 0, 1 }), 1.0));
	const std::vector<Motion> motion = find_motion(body_of({ 0, 1, 2, 3 }, { at(0, 0, 0), at(1, 0, 0), at(1, 0, 0), at(2, 0, 0) }));
	CHECK(motion == std::vector<Motion>{ Motion::UNKNOWN, Motion::MOVING, Motion::RESTING, Motion::MOVING });
}

TEST_CASE("pose error: percentiles interpolate linearly, as in tests/tools/test_pose_error.py") {
	struct Row {
		double share;
		double expected;
		std::vector<double> values;
	};
	const std::vector<Row> rows = {
#include "percentiles.inc"
	};
	CHECK(rows.size() == 11);
	for (Row row : rows) {
		CHECK(percentile(row.values, row.share) == doctest::Approx(row.expected).epsilon(1e-12));
	}
	const double infinity = std::numeric_limits<double>::infinity();
	std::vector<double> infinite = { infinity, 1.0, infinity };
	CHECK(percentile(infinite, 0.0) == 1.0);
	CHECK(percentile(infinite, 0.25) == infinity);
	CHECK(percentile(infinite, 0.75) == infinity);
	std::vector<double> none;
	CHECK(std::isnan(percentile(none, 0.5)));
}

TEST_CASE("pose error: resting samples are counted separately") {
	ErrorSummary summary;
	for (int i = 0; i < 900; ++i) {
		summary.add(0.0, Motion::RESTING);
	}
	for (int i = 0; i <= 100; ++i) {
		summary.add(0.001 * i, Motion::MOVING);
	}
	summary.add(9.0, Motion::UNKNOWN);
	const ErrorFigures figures = summary.figures();
	CHECK(figures.p50 == doctest::Approx(0.05));
	CHECK(figures.p99 == doctest::Approx(0.099));
	CHECK(figures.max == doctest::Approx(0.1));
	CHECK(figures.rest_p99 == 0.0);
	CHECK(figures.moving_count == 101);
	CHECK(figures.resting_count == 900);
	ErrorSummary both = summary;
	both.add(summary);
	CHECK(both.figures().moving_count == 202);
	CHECK(both.figures().p99 == doctest::Approx(0.099));
}

TEST_CASE("method result: runs are pooled") {
	MethodResult one;
	one.subject = "a";
	one.bytes_per_second = 10.0;
	one.delay_max = one.delay_median = 0.1;
	one.errors.add(0.001, Motion::MOVING);
	one.unseen = 4;
	MethodResult two = one;
	two.bytes_per_second = 30.0;
	two.delay_max = 0.5;
	two.errors.add(0.003, Motion::MOVING);
	const MethodResult pooled = pool_runs({ one, two });
	CHECK(pooled.subject == "a");
	CHECK(pooled.bytes_per_second == 20.0);
	CHECK(pooled.delay_max == 0.5);
	CHECK(pooled.delay_median == doctest::Approx(0.1));
	CHECK(pooled.errors.figures().moving_count == 3);
	CHECK(pooled.errors.figures().max == 0.003);
	CHECK(pooled.unseen == 4);
}
