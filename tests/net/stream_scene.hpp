#pragma once

#include "motion_scenes.hpp"
#include "net/stream/stream_encoder.hpp"

#include <doctest/doctest.h>

#include <map>

namespace net_test {

/// A scene in which bodies are added, removed, jump and move, observed by a StreamEncoder tick by tick.
class StreamScene {
public:
	struct Body {
		Path path;
		double born = 0.0; // ticks
		bool is_new = true; // in the current window
		bool planar = false;
		Vector3D offset{ 0.0 }; // of the last jump
		double jumped = -1e9; // time of the first jump in the current window
		double settled_from = -1e9; // time of the last one; between the two, the body is shown at its last target
		PoseD last;
	};

	/// If `has_planar_bodies`, bodies with odd ids are planar.
	StreamScene(net::StreamEncoder &encoder, unsigned seed, bool has_planar_bodies = false) :
			_encoder(encoder), _random(seed), _motions(motions(Vector3D(0.0))), _has_planar_bodies(has_planar_bodies) {}

	/// Applies all events and observes all poses of a tick. `event_probability` is the probability that a body is added and
	/// that one jumps, and twice the probability that one is removed.
	void step(double tick, double event_probability) {
		if (_random.uniform(0.0, 1.0) < event_probability) {
			add(uint32_t(_random.uniform(0.0, 40.0)), tick);
		}
		if (!bodies.empty() && _random.uniform(0.0, 1.0) < 0.5 * event_probability) {
			remove(random_body(), tick);
		}
		if (!bodies.empty() && _random.uniform(0.0, 1.0) < event_probability) {
			jump(random_body(), tick);
		}
		for (auto &entry : bodies) {
			const PoseD pose = pose_of(entry.second, tick);
			CHECK(_encoder.observe(entry.first, tick, pose));
			entry.second.last = pose;
		}
	}

	void add(uint32_t id, double tick) {
		Body body;
		body.path = _motions[size_t(_random.uniform(0.0, double(_motions.size()) - 1e-9))].path;
		body.born = tick;
		body.planar = _has_planar_bodies && id % 2 == 1;
		body.offset = _random.vector(20.0);
		const PoseD pose = pose_of(body, tick);
		const bool is_new = bodies.count(id) == 0;
		CHECK(_encoder.add_body(id, tick, pose, body.planar) == is_new);
		if (is_new) {
			bodies[id] = body;
		}
	}

	void remove(uint32_t id, double tick) {
		bodies.erase(id);
		CHECK(_encoder.remove_body(id, tick));
		CHECK_FALSE(_encoder.remove_body(id, tick));
	}

	void jump(uint32_t id, double tick) {
		Body &body = bodies[id];
		CHECK(_encoder.jump(id));
		body.offset = _random.vector(100.0);
		body.jumped = body.jumped < 0.0 ? (body.is_new ? body.born : tick) : body.jumped;
		body.settled_from = tick;
	}

	/// Call it after each window.
	void end_window() {
		for (auto &entry : bodies) {
			entry.second.jumped = -1e9;
			entry.second.is_new = false;
		}
	}

	static PoseD pose_of(const Body &body, double tick) {
		PoseD pose = body.path((tick - body.born) / 60.0);
		pose.translation += body.offset;
		if (body.planar) {
			pose = net::BodyState::planar_part(pose);
			pose.rotation = glm::normalize(pose.rotation);
		}
		return pose;
	}

	std::map<uint32_t, Body> bodies;

private:
	uint32_t random_body() {
		auto body = bodies.begin();
		std::advance(body, ptrdiff_t(_random.uniform(0.0, double(bodies.size()) - 1e-9)));
		return body->first;
	}

	net::StreamEncoder &_encoder;
	cga_test::Random _random;
	std::vector<Motion> _motions;
	bool _has_planar_bodies;
};

} // namespace net_test
