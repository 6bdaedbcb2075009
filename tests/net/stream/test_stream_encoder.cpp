#include "net/stream/stream_encoder.hpp"

#include "../stream_scene.hpp"
#include "net/motion/motion_track.hpp"
#include "net/stream/stream_decoder.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <memory>
#include <optional>

using namespace net;
using namespace net_test;

namespace {

using Bytes = std::vector<uint8_t>;

/// An encoder, a decoder that gets all of its windows, and the decoded motion of each body.
struct Link {
	explicit Link(cga::Mode mode = cga::Mode::SEPARATE) :
			mode(mode), encoder(0.005f, 1.4f, mode), decoder(0.005f, 1.4f, 1000) {
		Bytes snapshot;
		encoder.encode_snapshot(snapshot);
		REQUIRE(decoder.read_snapshot(snapshot.data(), snapshot.size()));
	}

	bool window(int ticks) {
		bytes.clear();
		encoder.encode_window(end, ticks, bytes);
		const std::optional<int> decoded = decoder.decode_window(bytes.data(), bytes.size(), { encoder.check(), 255 }, end, mode, motions);
		CHECK(decoded.value_or(ticks) == ticks);
		for (const BodyMotion &motion : motions) {
			tracks[motion.id].add(motion);
		}
		end += ticks;
		return decoded.has_value();
	}

	/// Sets `shown` to the pose at a time; false if the body does not exist then.
	[[nodiscard]] bool shows(uint32_t id, double tick) {
		const std::optional<PoseD> pose = tracks[id].pose_at(tick);
		shown = pose.value_or(PoseD());
		return pose.has_value();
	}

	cga::Mode mode;
	StreamEncoder encoder;
	StreamDecoder decoder;
	Bytes bytes;
	std::vector<BodyMotion> motions;
	std::map<uint32_t, MotionTrack> tracks;
	double end = 0.0;
	PoseD shown;
};

bool is_planar(const PoseD &pose) {
	return std::abs(pose.translation.z) + std::abs(pose.rotation.x) + std::abs(pose.rotation.y) < 1e-12;
}

PoseD at(double x) {
	PoseD pose;
	pose.translation.x = x;
	return pose;
}

} // namespace

TEST_CASE("stream: a decoder follows random scenes, within the tolerance at every tick") {
	for (const cga::Mode mode : { cga::Mode::SEPARATE, cga::Mode::LINEAR, cga::Mode::SCREW }) {
		for (unsigned seed = 1; seed <= 10; ++seed) {
			Link link(mode);
			StreamScene scene(link.encoder, seed, seed > 6);
			cga_test::Random random(seed + 100);
			double worst = 0.0;
			int checked = 0;
			for (double tick = 0.0; tick < 900.0;) {
				const int ticks = seed % 2 == 0 ? 12 : int(random.uniform(1.0, seed == 1 ? 64.9 : 20.0));
				std::vector<std::map<uint32_t, StreamScene::Body>> truth;
				for (int i = 0; i < ticks; ++i) {
					scene.step(++tick, seed < 3 ? 0.3 : 0.03);
					truth.push_back(scene.bodies);
				}
				CAPTURE(seed);
				CAPTURE(tick);
				REQUIRE(link.window(ticks));
				CHECK(link.decoder.body_count() == scene.bodies.size());
				CHECK(link.encoder.body_count() == scene.bodies.size());
				for (int i = 0; i < ticks; ++i) {
					const double time = tick - ticks + i + 1;
					for (const auto &entry : truth[size_t(i)]) {
						const auto now = scene.bodies.find(entry.first);
						const bool is_same_life = now != scene.bodies.end() && now->second.born == entry.second.born;
						const bool between_jumps = is_same_life && time >= now->second.jumped && time < now->second.settled_from;
						if (is_same_life && !between_jumps) {
							REQUIRE(link.shows(entry.first, time));
							CHECK((!entry.second.planar || is_planar(link.shown)));
							worst = std::max(worst, error_share(link.shown, entry.second.last, link.encoder.grid()));
							++checked;
						}
					}
				}
				scene.end_window();
			}
			CAPTURE(int(mode));
			CHECK(worst <= 1.05);
			CHECK(checked > 1000);
		}
	}
}

TEST_CASE("stream: a decoder that starts at a later snapshot agrees with one that decoded all windows") {
	for (const bool has_planar_bodies : { false, true }) {
		Link link;
		StreamScene scene(link.encoder, 9, has_planar_bodies);
		std::vector<std::unique_ptr<StreamDecoder>> others;
		double tick = 0.0;
		for (int window = 0; window < 60; ++window) {
			for (int i = 0; i < 10; ++i) {
				scene.step(++tick, 0.05);
			}
			const double begin = link.end;
			REQUIRE(link.window(10));
			scene.end_window();
			for (auto &other : others) {
				std::vector<BodyMotion> motions;
				REQUIRE(other->decode_window(link.bytes.data(), link.bytes.size(), { link.encoder.check(), 255 }, begin, link.mode, motions));
				REQUIRE(other->body_count() == link.decoder.body_count());
				CHECK(motions.size() == link.motions.size());
				for (size_t i = 0; i < other->body_count(); ++i) {
					CHECK(other->id(i) == link.decoder.id(i));
					CHECK(cga_test::difference(other->pose(i), link.decoder.pose(i)) == 0.0);
				}
			}
			if (window % 10 == 3) {
				Bytes snapshot;
				link.encoder.encode_snapshot(snapshot);
				CHECK(snapshot.size() < 8192 / 4 + 96 * scene.bodies.size());
				others.push_back(std::make_unique<StreamDecoder>(0.005f, 1.4f, 1000));
				REQUIRE(others.back()->read_snapshot(snapshot.data(), snapshot.size()));
			}
		}
	}
}

TEST_CASE("stream: 200 bodies at rest together cost at most two bytes per window") {
	Link link;
	for (uint32_t id = 0; id < 200; ++id) {
		REQUIRE(link.encoder.add_body(id, 0.0, at(double(id))));
	}
	CHECK(link.encoder.has_changes());
	size_t last = 0;
	for (int window = 0; window < 40; ++window) {
		for (int i = 1; i <= 12; ++i) {
			for (uint32_t id = 0; id < 200; ++id) {
				CHECK(link.encoder.observe(id, link.end + i, at(double(id))));
			}
		}
		REQUIRE(link.window(12));
		last = link.bytes.size();
	}
	CHECK_FALSE(link.encoder.has_changes());
	CHECK(link.encoder.moving_count() == 0);
	CHECK(last <= 2);
	// One of them begins to move.
	CHECK(link.encoder.observe(7, link.end + 1.0, at(7.5)));
	CHECK(link.encoder.has_changes());
	REQUIRE(link.window(12));
	CHECK(link.encoder.moving_count() == 1);
	CHECK(link.bytes.size() <= 16);
}

TEST_CASE("stream: poses that are not finite or out of range are rejected without a change") {
	Link link;
	REQUIRE(link.encoder.add_body(1, 0.0, at(1.0)));
	REQUIRE(link.window(1));
	const double nan = std::numeric_limits<double>::quiet_NaN();
	PoseD flat = at(1.0);
	flat.scale = 0.0;
	PoseD unrotated = at(1.0);
	unrotated.rotation = QuaternionD(0, 0, 0, 0);
	for (const PoseD &bad : { at(nan), at(1e300), at(std::numeric_limits<double>::infinity()), flat, unrotated }) {
		CHECK_FALSE(link.encoder.observe(1, 2.0, bad));
		CHECK_FALSE(link.encoder.add_body(2, 2.0, bad));
	}
	CHECK_FALSE(link.encoder.observe(2, 2.0, at(0.0)));
	CHECK_FALSE(link.encoder.add_body(1, 2.0, at(0.0)));
	CHECK_FALSE(link.encoder.add_body(ID_LIMIT, 2.0, at(0.0)));
	CHECK_FALSE(link.encoder.jump(2));
	CHECK_FALSE(link.encoder.has_changes());
	CHECK(link.encoder.body_count() == 1);
	REQUIRE(link.window(12));
	CHECK(link.decoder.body_count() == 1);
	CHECK(link.shows(1, link.end));
	CHECK(cga_test::difference(link.shown, at(1.0)) < 1e-3);
}

TEST_CASE("stream: a jump is shown at its time; several in a window become one to the last target") {
	Link link;
	REQUIRE(link.encoder.add_body(1, 0.0, at(0.0)));
	REQUIRE(link.window(1));
	for (int tick = 2; tick <= 13; ++tick) {
		if (tick == 5 || tick == 9) {
			CHECK(link.encoder.jump(1));
		}
		CHECK(link.encoder.observe(1, tick, at(tick < 5 ? 0.1 * tick : (tick < 9 ? 50.0 : 90.0 + tick))));
	}
	REQUIRE(link.window(12));
	REQUIRE(link.shows(1, 4.9));
	CHECK(link.shown.translation.x < 0.6);
	REQUIRE(link.shows(1, 5.0));
	CHECK(link.shown.translation.x == doctest::Approx(99.0).epsilon(1e-4));
	REQUIRE(link.shows(1, 13.0));
	CHECK(link.shown.translation.x == doctest::Approx(103.0).epsilon(1e-4));
}

TEST_CASE("stream: a jump right after a pose, and a jump whose pose follows in a later window") {
	for (const double after : { 0.0, 0.05, 3.0 }) {
		Link link;
		REQUIRE(link.encoder.add_body(1, 0.0, at(0.0)));
		REQUIRE(link.window(1));
		for (int tick = 2; tick <= 6; ++tick) {
			CHECK(link.encoder.observe(1, tick, at(0.3 * tick)));
		}
		CHECK(link.encoder.jump(1));
		CHECK(link.encoder.observe(1, 6.0 + after, at(77.0)));
		CAPTURE(after);
		REQUIRE(link.window(6));
		for (int tick = 10; tick <= 20; ++tick) {
			CHECK(link.encoder.observe(1, tick, at(77.0)));
		}
		REQUIRE(link.window(13));
		REQUIRE(link.shows(1, 5.0));
		CHECK(link.shown.translation.x == doctest::Approx(1.5).epsilon(0.01));
		REQUIRE(link.shows(1, 6.0 + std::ceil(after)));
		CHECK(link.shown.translation.x == doctest::Approx(77.0).epsilon(1e-4));
		REQUIRE(link.shows(1, 5.99));
		CHECK(link.shown.translation.x < 2.0);
	}
}

TEST_CASE("stream: bodies added and removed within a window, after its end, and again under the same id") {
	Link link;
	REQUIRE(link.encoder.add_body(1, 0.0, at(1.0)));
	REQUIRE(link.encoder.add_body(2, 0.4, at(2.0)));
	CHECK(link.encoder.remove_body(2, 0.6)); // never existed for the decoder
	REQUIRE(link.window(4));
	CHECK(link.decoder.body_count() == 1);
	// Added after the window's end: part of the next one.
	REQUIRE(link.encoder.add_body(3, 8.5, at(3.0)));
	REQUIRE(link.window(4));
	CHECK(link.decoder.body_count() == 1);
	REQUIRE(link.encoder.add_body(4, 8.7, at(4.0)));
	REQUIRE(link.window(4));
	CHECK(link.decoder.body_count() == 3);
	CHECK_FALSE(link.shows(3, 7.9));
	CHECK(link.shows(3, 8.5));
	// Added after the window's end and removed before the next.
	REQUIRE(link.encoder.add_body(5, 12.5, at(5.0)));
	CHECK(link.encoder.remove_body(5, 12.5));
	REQUIRE(link.window(1)); // ends at 13
	REQUIRE(link.encoder.add_body(6, 13.5, at(6.0)));
	CHECK(link.encoder.remove_body(6, 13.5));
	REQUIRE(link.encoder.add_body(7, 13.6, at(7.0)));
	REQUIRE(link.window(1)); // ends at 14
	REQUIRE(link.encoder.add_body(8, 15.5, at(8.0)));
	CHECK(link.encoder.remove_body(8, 15.5));
	REQUIRE(link.window(1)); // ends at 15: body 8 was added after its end, and has been removed
	CHECK(link.decoder.body_count() == 4);
	// The same id, removed and added again elsewhere.
	CHECK(link.encoder.remove_body(1, 16.0));
	REQUIRE(link.encoder.add_body(1, 18.0, at(-1.0)));
	REQUIRE(link.window(5));
	CHECK(link.decoder.body_count() == 4);
	REQUIRE(link.shows(1, 15.0));
	CHECK(link.shown.translation.x == doctest::Approx(1.0).epsilon(1e-3));
	CHECK_FALSE(link.shows(1, 17.0));
	REQUIRE(link.shows(1, 19.0));
	CHECK(link.shown.translation.x == doctest::Approx(-1.0).epsilon(1e-3));
}

TEST_CASE("stream: after a long gap between its poses a body jumps") {
	Link link;
	REQUIRE(link.encoder.add_body(1, 0.0, at(0.0)));
	for (int tick = 1; tick <= 40; ++tick) {
		const bool hidden = tick > 12 && tick < 37;
		CHECK((hidden || link.encoder.observe(1, tick, at(0.2 * tick))));
		if (tick % 6 == 0) {
			REQUIRE(link.window(6));
		}
	}
	REQUIRE(link.shows(1, 36.0));
	CHECK(link.shown.translation.x < 4.0); // its motion was extrapolated for a while, then it stopped
	REQUIRE(link.window(4));
	REQUIRE(link.shows(1, 36.9));
	CHECK(link.shown.translation.x < 4.0);
	REQUIRE(link.shows(1, 37.0));
	CHECK(link.shown.translation.x == doctest::Approx(7.4).epsilon(0.001));
}

TEST_CASE("stream: of the poses of a planar body only x, y, the rotation about z and the scale count") {
	Link link;
	PoseD pose{ Vector3D(1.0, -2.0, 3.0), cga_test::axis_angle(Vector3D(0, 0, 1), 1.0), 2.0 };
	REQUIRE(link.encoder.add_body(1, 0.0, pose, true));
	REQUIRE(link.window(1));
	CHECK(link.encoder.observe(1, 2.0, pose));
	CHECK_FALSE(link.encoder.has_changes());
	pose.translation.z = std::numeric_limits<double>::quiet_NaN();
	CHECK(link.encoder.observe(1, 3.0, pose));
	CHECK_FALSE(link.encoder.has_changes());
	REQUIRE(link.window(12));
	REQUIRE(link.shows(1, link.end));
	CHECK(is_planar(link.shown));
	pose.translation.z = 0.0;
	CHECK(error_share(link.shown, pose, link.encoder.grid()) < 0.1);
	// Half a turn about x: no rotation about z is nearest to it.
	pose.rotation = QuaternionD(0, 1, 0, 0);
	CHECK_FALSE(link.encoder.observe(1, 14.0, pose));
	CHECK_FALSE(link.encoder.add_body(2, 14.0, pose, true));
	CHECK(link.encoder.add_body(2, 14.0, pose));
}
