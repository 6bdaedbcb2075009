#include "net/motion/motion_track.hpp"

#include <doctest/doctest.h>

using namespace net;

namespace {

/// A motion along x from `from` by `displacement` over ticks `begin` to `end`.
BodyMotion moving(double begin, double end, double from, double displacement) {
	BodyMotion motion;
	motion.segment.begin = begin;
	motion.segment.length = end - begin;
	motion.segment.start.translation.x = from;
	motion.segment.displacement.x = displacement;
	return motion;
}

BodyMotion appearing(double begin, double at) {
	BodyMotion motion = moving(begin, begin + 1.0, at, 0.0);
	motion.appears = true;
	return motion;
}

BodyMotion vanishing(double begin) {
	BodyMotion motion;
	motion.vanishes = true;
	motion.segment.begin = begin;
	return motion;
}

constexpr double ABSENT = -1e9;

double x_at(const MotionTrack &track, double tick) {
	const std::optional<cga::Pose<double>> pose = track.pose_at(tick);
	return pose ? pose->translation.x : ABSENT;
}

} // namespace

TEST_CASE("motion track: consecutive segments, and rest between and after them") {
	MotionTrack track;
	CHECK(x_at(track, 0.0) == ABSENT);
	CHECK(track.is_over(0.0));
	track.add(moving(10.0, 20.0, 1.0, 2.0));
	track.add(moving(30.0, 34.0, 3.0, -4.0));
	for (const auto &row : { std::pair<double, double>{ -5.0, 1.0 }, { 10.0, 1.0 }, { 15.0, 2.0 }, { 20.0, 3.0 }, { 25.0, 3.0 }, { 30.0, 3.0 }, { 31.0, 2.0 }, { 34.0, -1.0 }, { 1e6, -1.0 } }) {
		CAPTURE(row.first);
		CHECK(x_at(track, row.first) == row.second);
	}
	CHECK_FALSE(track.is_over(1e6));
}

TEST_CASE("motion track: a jump is shown at its time, without interpolation") {
	MotionTrack track;
	track.add(moving(0.0, 10.0, 0.0, 10.0));
	track.add(appearing(10.0, 100.0));
	track.add(moving(10.0, 20.0, 100.0, 10.0));
	CHECK(x_at(track, 9.999) == doctest::Approx(9.999));
	CHECK(x_at(track, 10.0) == 100.0);
	CHECK(x_at(track, 15.0) == 105.0);
	track.forget_before(10.0);
	CHECK(x_at(track, 10.0) == 100.0);
}

TEST_CASE("motion track: bodies appear, vanish and appear again") {
	MotionTrack track;
	track.add(appearing(10.0, 1.0));
	track.add(vanishing(20.0));
	track.add(appearing(30.0, 2.0));
	CHECK(x_at(track, 9.9) == ABSENT);
	CHECK(x_at(track, 10.0) == 1.0);
	CHECK(x_at(track, 19.9) == 1.0);
	CHECK(x_at(track, 20.0) == ABSENT);
	CHECK(x_at(track, 29.9) == ABSENT);
	CHECK(x_at(track, 30.0) == 2.0);
	CHECK_FALSE(track.is_over(25.0));
	track.add(vanishing(40.0));
	CHECK_FALSE(track.is_over(39.9));
	CHECK(track.is_over(40.0));
	CHECK_FALSE(track.is_empty());
}

TEST_CASE("motion track: a new motion replaces known motion from its begin on") {
	MotionTrack track;
	track.add(moving(0.0, 10.0, 0.0, 10.0));
	track.add(moving(10.0, 20.0, 10.0, 10.0));
	track.add(moving(20.0, 30.0, 20.0, 10.0));
	track.add(moving(10.0, 14.0, 10.0, -4.0));
	CHECK(x_at(track, 5.0) == 5.0);
	CHECK(x_at(track, 14.0) == 6.0);
	CHECK(x_at(track, 25.0) == 6.0);
	// A motion that begins where the body appears does not replace its appearance.
	MotionTrack other;
	other.add(appearing(5.0, 1.0));
	other.add(moving(5.0, 6.0, 1.0, 1.0));
	CHECK(x_at(other, 4.0) == ABSENT);
	CHECK(x_at(other, 5.5) == 1.5);
}

TEST_CASE("motion track: segments that have been shown are dropped, and memory is bounded even if none is shown") {
	MotionTrack track;
	for (int i = 0; i < 10; ++i) {
		track.add(moving(i, i + 1, i, 1.0));
	}
	track.forget_before(7.5);
	CHECK(x_at(track, 7.5) == 7.5);
	CHECK(x_at(track, 2.0) == 7.0); // no longer known
	for (int i = 10; i < 5000; ++i) {
		track.add(moving(i, i + 1, i, 1.0));
	}
	CHECK(x_at(track, 4999.5) == 4999.5);
	CHECK(x_at(track, 0.0) == doctest::Approx(5000.0 - double(MotionTrack::MAX_SEGMENTS)));
}
