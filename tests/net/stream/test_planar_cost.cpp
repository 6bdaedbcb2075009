#include "../motion_scenes.hpp"
#include "net/stream/stream_encoder.hpp"

#include <doctest/doctest.h>

// The bytes of planar bodies, compared with the same motion coded in 3D and with a coder that knows only x, y and an angle.

using namespace net;
using namespace net_test;

namespace {

constexpr float POSITION_TOLERANCE = 0.005f; // 0.5 pixels of 0.01 m
constexpr float ROTATION_TOLERANCE = 1.4f;
constexpr double TICK = 1.0 / 60.0;
constexpr int WINDOW = 11; // ticks
constexpr int WINDOWS = 328; // one minute, after the first window, which adds the bodies and is not counted
constexpr double SECONDS = WINDOW * (WINDOWS - 1) * TICK;
constexpr uint32_t BODIES = 8;

const Vector3D Z(0.0, 0.0, 1.0);

struct FlatMotion {
	std::string name;
	std::function<PoseD(uint32_t, double)> pose; // of a body, at a time in seconds
};

/// Motions in the plane: 1 m is 100 pixels.
std::vector<FlatMotion> flat_motions() {
	return {
		{ "walk", [](uint32_t id, double t) {
			 const double phase = 1.7 * id;
			 const double x = 1.5 * std::sin(0.7 * t + phase) + 0.6 * std::sin(2.3 * t + 2.0 * phase) + 0.05 * std::sin(9.1 * t);
			 const double y = 1.2 * std::sin(0.9 * t + 0.4 * phase) + 0.5 * std::sin(2.9 * t + phase) + 0.05 * std::sin(8.3 * t + phase);
			 return turned_at(Vector3D(x, y, 0.0), Z, 1.5 * std::sin(1.1 * t + phase) + 0.4 * std::sin(5.3 * t));
		 } },
		{ "roll", [](uint32_t id, double t) {
			 const double x = 3.0 * std::sin(0.8 * t + id);
			 return turned_at(Vector3D(x, bounce(std::fmod(t + 0.3 * id, 3.0), 1.5), 0.0), Z, -x / 0.16);
		 } },
		{ "slide", [](uint32_t id, double t) { return turned_at(Vector3D(4.0 * std::sin(0.5 * t + id), double(id), 0.0), Z, 0.3); } },
		{ "orbit and spin", [](uint32_t id, double t) { return turned_at(Vector3D(2.0 * std::cos(t + id), 2.0 * std::sin(t + id), 0.0), Z, 3.0 * t); } },
	};
}

/// Bytes per second and body of all windows.
double stream_cost(const FlatMotion &motion, bool planar) {
	StreamEncoder encoder(POSITION_TOLERANCE, ROTATION_TOLERANCE, cga::Mode::SEPARATE);
	for (uint32_t id = 0; id < BODIES; ++id) {
		REQUIRE(encoder.add_body(id, 0.0, motion.pose(id, 0.0), planar));
	}
	std::vector<uint8_t> bytes;
	for (int window = 0; window < WINDOWS; ++window) {
		if (window == 1) {
			bytes.clear();
		}
		for (int tick = window * WINDOW + 1; tick <= (window + 1) * WINDOW; ++tick) {
			for (uint32_t id = 0; id < BODIES; ++id) {
				CHECK(encoder.observe(id, tick, motion.pose(id, tick * TICK)));
			}
		}
		encoder.encode_window(window * WINDOW, WINDOW, bytes);
	}
	return double(bytes.size()) / SECONDS / BODIES;
}

/// A coder of segments with the numbers of a motion in the plane only: x, y, the angle and their curvatures.
class FlatCoder {
public:
	explicit FlatCoder(RangeEncoder &coder) :
			_coder(coder) {}

	struct Body {
		MeanMagnitude residual[2] = { MeanMagnitude(512), MeanMagnitude(512) };
		MeanMagnitude curvature[2] = { MeanMagnitude(256), MeanMagnitude(256) };
		bool active = false;
		bool curved[2] = { false, false };
	};

	void code(Body &body, const MotionCode &motion) {
		bool active = motion.active;
		_coder.bit(_active[body.active ? 1 : 0], active);
		body.active = active;
		for (int i = 0; active && i < motion.count; ++i) {
			bool split = i + 1 < motion.count;
			_coder.bit(_split[std::min(i, 2)], split);
			if (split) {
				_coder.bits(uint32_t(motion.segments[size_t(i)].ticks), 4);
			}
			code(body, motion.segments[size_t(i)]);
		}
	}

private:
	void code(Body &body, const SegmentCode &segment) {
		_coder.bit(_fine, segment.fine);
		const int fine = segment.fine ? 2 : 1;
		int32_t x = segment.residual[0];
		int32_t y = segment.residual[1];
		int32_t angle = segment.residual[5];
		const int32_t mean = body.residual[0].value() * fine;
		_residual[0].code(_coder, x, mean);
		_residual[0].code(_coder, y, (3 * mean + std::min(std::abs(x), MeanMagnitude::MAX) * 256) / 4);
		_residual[1].code(_coder, angle, body.residual[1].value() * fine);
		body.residual[0].add(x / fine);
		body.residual[0].add(y / fine);
		body.residual[1].add(angle / fine);
		for (int group = 0; group < 2; ++group) {
			_coder.bit(_curved[group][body.curved[group] ? 1 : 0], segment.curved[group]);
			body.curved[group] = segment.curved[group];
		}
		for (const int i : { 0, 1, 5 }) {
			const int group = i / 3;
			if (segment.curved[group]) {
				int32_t curvature = segment.curvature[i];
				_curvature[group].code(_coder, curvature, body.curvature[group].value());
				body.curvature[group].add(curvature);
			}
		}
	}

	RangeEncoder &_coder;
	ResidualModel _residual[2];
	ResidualModel _curvature[2];
	AdaptiveBit _active[2];
	AdaptiveBit _split[3];
	AdaptiveBit _fine{ 60000 };
	AdaptiveBit _curved[2][2];
};

/// Bytes per second and body of FlatCoder, without any header.
double flat_cost(const FlatMotion &motion) {
	const StreamGrid grid(POSITION_TOLERANCE, ROTATION_TOLERANCE);
	MotionPlanner planner(grid, cga::Mode::SEPARATE);
	MotionModels models;
	MotionCode code;
	std::vector<uint8_t> unused;
	RangeEncoder stream_coder(unused); // advances the state and adapts the models
	std::vector<uint8_t> bytes;
	RangeEncoder coder(bytes);
	FlatCoder flat(coder);
	std::vector<BodyState> states(BODIES);
	std::vector<FlatCoder::Body> bodies(BODIES);
	std::vector<MotionSample> samples(WINDOW);
	for (uint32_t id = 0; id < BODIES; ++id) {
		states[id].planar = true;
		REQUIRE(states[id].set_pose(motion.pose(id, 0.0), grid));
	}
	size_t first_window = 0; // its bytes
	for (int window = 0; window < WINDOWS; ++window) {
		first_window = window == 1 ? bytes.size() : first_window;
		const int begin = window * WINDOW;
		for (uint32_t id = 0; id < BODIES; ++id) {
			for (int i = 0; i < WINDOW; ++i) {
				samples[size_t(i)] = { double(begin + i + 1), motion.pose(id, (begin + i + 1) * TICK) };
			}
			planner.plan(states[id], begin, WINDOW, samples.data(), samples.size(), samples.size(), models, code);
			flat.code(bodies[id], code);
			REQUIRE(code_motion(stream_coder, models, states[id], grid, begin, WINDOW, true, code, [](const BodyState &, const SegmentCode &, const SegmentSteps &, double) {}));
		}
	}
	coder.finish();
	return double(bytes.size() - first_window) / SECONDS / BODIES;
}

} // namespace

TEST_CASE("planar bodies: what 3D adds costs at most 0.5 bytes per second and body") {
	for (const FlatMotion &motion : flat_motions()) {
		const double planar = stream_cost(motion, true);
		const double spatial = stream_cost(motion, false);
		const double flat = flat_cost(motion);
		CAPTURE(motion.name);
		CHECK(planar <= flat + 0.5);
		CHECK(planar <= spatial);
	}
}
