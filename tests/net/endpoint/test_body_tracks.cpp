#include "net/endpoint/body_tracks.hpp"

#include <doctest/doctest.h>

#include <map>

using namespace net;

namespace {

BodyMotion moving(uint32_t id, double begin) {
	BodyMotion motion = BodyMotion::rest(id, begin, {}, false);
	motion.segment.displacement.x = 1.0;
	return motion;
}

void add(BodyTracks &tracks, BodyMotion motion) {
	tracks.add(motion);
}

std::map<BodyEvent::Kind, int> count_events(BodyTracks &tracks) {
	std::vector<BodyEvent> events;
	tracks.take_events(events);
	std::map<BodyEvent::Kind, int> counts;
	for (const BodyEvent &event : events) {
		++counts[event.kind];
	}
	return counts;
}

} // namespace

TEST_CASE("body tracks: time visits only bodies with motion to come") {
	BodyTracks tracks(1000);
	for (uint32_t id = 0; id < 1000; ++id) {
		add(tracks, BodyMotion::rest(id, 0.0, {}, false));
	}
	CHECK(tracks.busy_count() == 0);
	add(tracks, moving(7, 5.0));
	add(tracks, BodyMotion::removal(8, 10.0));
	CHECK(tracks.busy_count() == 2);
	tracks.advance(6.0, 100.0);
	CHECK(tracks.busy_count() == 1);
	CHECK(tracks.find(8)->pose_at(6.0));
	tracks.advance(10.0, 100.0);
	CHECK(tracks.busy_count() == 0);
	CHECK(tracks.find(8) == nullptr);
	CHECK(tracks.count() == 999);
	CHECK(count_events(tracks)[BodyEvent::REMOVED] == 1);
	// On another time line, all bodies continue, but only those that get motion are shown.
	tracks.restart(50.0);
	add(tracks, BodyMotion::rest(3, 50.0, {}, false));
	CHECK(tracks.find(3)->life() != 0);
	tracks.advance(50.0, 100.0);
	CHECK(tracks.count() == 1);
	CHECK(count_events(tracks)[BodyEvent::REMOVED] == 998);
}

TEST_CASE("body tracks: bodies that have ended make room for others before playback reaches their end") {
	BodyTracks tracks(10);
	for (uint32_t id = 0; id < 1000; ++id) {
		add(tracks, BodyMotion::rest(id, 0.0, {}, true));
		add(tracks, moving(id, 1.0));
		add(tracks, BodyMotion::removal(id, 2.0));
		CHECK(tracks.count() <= tracks.max_tracks());
	}
	CHECK(tracks.find(999)->pose_at(1.0));
	CHECK(tracks.find(0) == nullptr);
	const size_t known = tracks.count();
	CHECK(size_t(count_events(tracks)[BodyEvent::ADDED]) <= tracks.max_tracks());
	tracks.advance(3.0, 100.0);
	CHECK(tracks.count() == 0);
	CHECK(tracks.capacity() == 0);
	CHECK(size_t(count_events(tracks)[BodyEvent::REMOVED]) == known);
}

TEST_CASE("body tracks: their memory is that of a few segments for each body, wherever these are") {
	BodyTracks tracks(100);
	const size_t limit = tracks.max_capacity();
	CHECK(limit == 8 * 100 + 4096);
	double tick = 0.0;
	for (int i = 0; i < 400; ++i, ++tick) {
		for (uint32_t id = 0; id < 100; ++id) {
			add(tracks, moving(id, tick));
		}
		CHECK(tracks.capacity() <= limit + MotionTrack::MAX_CAPACITY + 100 * MotionTrack::MIN_CAPACITY);
	}
	CHECK(tracks.capacity() > limit / 2);
	for (uint32_t id = 0; id < 100; ++id) {
		CHECK(tracks.find(id)->pose_at(tick)->translation.x == 1.0); // the newest motion is known
	}
	// A few bodies with much motion keep all of it.
	BodyTracks few(100);
	for (int i = 0; i < 200; ++i) {
		add(few, moving(1, double(i)));
	}
	CHECK(few.find(1)->motion_at(0.5)->segment.begin == 0.0);
	few.advance(1000.0, 100.0);
	CHECK(few.capacity() < 200);
}

TEST_CASE("body tracks: ends are known for a while") {
	BodyTracks tracks(10);
	BodyMotion motion = BodyMotion::rest(1, 0.0, {}, true);
	tracks.add(motion);
	const uint64_t life = motion.life;
	add(tracks, BodyMotion::removal(1, 10.0, true));
	tracks.advance(9.0, 100.0);
	CHECK(tracks.end(1, life, 9.0) == BodyEnd::NONE);
	CHECK(tracks.last_pose(1, life));
	tracks.advance(20.0, 100.0);
	CHECK(tracks.end(1, life, 20.0) == BodyEnd::FREED);
	CHECK(tracks.end(2, life, 20.0) == BodyEnd::NONE);
	tracks.advance(111.0, 100.0);
	CHECK(tracks.end(1, life, 111.0) == BodyEnd::NONE);
	tracks.advance(130.0, 100.0);
	CHECK_FALSE(tracks.last_pose(1, life));
}
