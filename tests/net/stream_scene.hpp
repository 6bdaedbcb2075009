#pragma once

#include "motion_scenes.hpp"
#include "net/stream/stream_encoder.hpp"

#include <doctest/doctest.h>

#include <map>

namespace net_test {

/// A scene in which bodies come, go, jump and move in all ways, told to a StreamEncoder tick by tick.
class StreamScene {
public:
	struct Body {
		Path path;
		double born = 0.0; // ticks
		bool is_new = true; // in the current window
		Vector3D offset{ 0.0 }; // of the last jump
		double jumped = -1e9; // time of the first jump in the current window
		double settled_from = -1e9; // time of the last one: between the two it is elsewhere than shown
		PoseD last;
	};

	StreamScene(net::StreamEncoder &encoder, unsigned seed) :
			encoder_(encoder), random_(seed), motions_(motions(Vector3D(0.0))) {}

	/// Everything that happens at a tick; `turmoil` is the chance that a body comes, one goes, one jumps.
	void step(double tick, double turmoil) {
		if (random_.uniform(0.0, 1.0) < turmoil) {
			add(std::uint32_t(random_.uniform(0.0, 40.0)), tick);
		}
		if (!bodies.empty() && random_.uniform(0.0, 1.0) < 0.5 * turmoil) {
			remove(some_body(), tick);
		}
		if (!bodies.empty() && random_.uniform(0.0, 1.0) < turmoil) {
			jump(some_body(), tick);
		}
		for (auto &entry : bodies) {
			const PoseD pose = pose_of(entry.second, tick);
			CHECK(encoder_.observe(entry.first, tick, pose));
			entry.second.last = pose;
		}
	}

	void add(std::uint32_t id, double tick) {
		Body body;
		body.path = motions_[std::size_t(random_.uniform(0.0, double(motions_.size()) - 1e-9))].path;
		body.born = tick;
		body.offset = random_.vector(20.0);
		const PoseD pose = pose_of(body, tick);
		const bool is_new = bodies.count(id) == 0;
		CHECK(encoder_.add_body(id, tick, pose) == is_new);
		if (is_new) {
			bodies[id] = body;
		}
	}

	void remove(std::uint32_t id, double tick) {
		bodies.erase(id);
		CHECK(encoder_.remove_body(id, tick));
		CHECK_FALSE(encoder_.remove_body(id, tick));
	}

	void jump(std::uint32_t id, double tick) {
		Body &body = bodies[id];
		CHECK(encoder_.jump(id));
		body.offset = random_.vector(100.0);
		body.jumped = body.jumped < 0.0 ? (body.is_new ? body.born : tick) : body.jumped;
		body.settled_from = tick;
	}

	/// To call after each window.
	void end_window() {
		for (auto &entry : bodies) {
			entry.second.jumped = -1e9;
			entry.second.is_new = false;
		}
	}

	static PoseD pose_of(const Body &body, double tick) {
		PoseD pose = body.path((tick - body.born) / 60.0);
		pose.translation += body.offset;
		return pose;
	}

	std::map<std::uint32_t, Body> bodies;

private:
	std::uint32_t some_body() {
		auto body = bodies.begin();
		std::advance(body, std::ptrdiff_t(random_.uniform(0.0, double(bodies.size()) - 1e-9)));
		return body->first;
	}

	net::StreamEncoder &encoder_;
	cga_test::Random random_;
	std::vector<Motion> motions_;
};

} // namespace net_test
