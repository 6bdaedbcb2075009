#pragma once

#include "motion.hpp"

#include "cga/motor/deviation.hpp"
#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"
#include "net/stream/stream_settings.hpp"

#include <array>
#include <map>

namespace fuzz {

/// Bodies of a sender whose motion the fuzzer chooses tick by tick, and where they were at each tick.
class MovingBodies {
public:
	static constexpr uint32_t COUNT = 3;
	/// The events of one body are at least this many ticks apart, more than a window has: of two jumps in one window only the
	/// last is sent.
	static constexpr int64_t EVENT_INTERVAL = 70;
	/// In rotation tolerances.
	static constexpr double MAX_ANGLE = 1.0;

	/// Observes all bodies at tick 0 or a later one.
	void step(net::Sender &sender, int64_t tick, Input &input) {
		for (uint32_t id = 0; id < COUNT; ++id) {
			Body &body = _bodies[id];
			const uint8_t choice = input.byte();
			const bool may_change = tick - body.event_tick >= EVENT_INTERVAL;
			if (!body.exists) {
				if ((choice & 3) == 0 && may_change) {
					add(sender, id, tick, input);
				}
				continue;
			}
			if (choice >= 250 && may_change) {
				require(sender.remove_body(id, choice == 255), "a body cannot be removed");
				body.exists = false;
				body.event_tick = tick;
				continue;
			}
			if (choice >= 240 && may_change) {
				require(sender.teleport(id), "a body cannot be teleported");
				body.pose.translation += cga::Vector3<double>(input.between(-100.0, 100.0), input.between(-100.0, 100.0), 0.0);
				body.event_tick = tick;
			} else if (choice >= 200) {
				body.velocity = { input.between(-0.5, 0.5), input.between(-0.5, 0.5), body.planar ? 0.0 : input.between(-0.5, 0.5) };
				body.spin = input.between(-0.3, 0.3);
				body.growth = input.flag() ? 1.0 : std::exp(input.between(-0.02, 0.02));
			} else if (choice >= 180) {
				body.velocity = cga::Vector3<double>(0.0);
				body.spin = 0.0;
				body.growth = 1.0;
			}
			move(body, tick);
			require(sender.observe(id, double(tick) * TICK, body.pose), "a valid pose was rejected");
			body.path[tick] = body.pose;
		}
	}

	/// Checks what a receiver shows from its media time to its known time, at whole ticks. `relaxation` is that of its stream.
	void check(const net::Receiver &receiver, double relaxation) {
		_relaxation = std::max(_relaxation, relaxation);
		const auto first = int64_t(std::ceil(receiver.media_time() / TICK - 1e-6));
		const auto last = int64_t(std::floor(receiver.known_time() / TICK + 1e-6));
		// The motion before a snapshot may never have arrived.
		_exact_from = receiver.snapshot_count() != _snapshots ? last : _exact_from;
		_snapshots = receiver.snapshot_count();
		for (int64_t tick = std::max({ first, last - 8, _exact_from }); tick <= last; ++tick) {
			for (uint32_t id = 0; id < COUNT; ++id) {
				check_pose(receiver, id, tick);
			}
		}
	}

	/// Whether the receiver knows the bodies that exist, at the poses where they are.
	[[nodiscard]] bool is_complete(const net::Receiver &receiver) const {
		for (uint32_t id = 0; id < COUNT; ++id) {
			if (_bodies[id].exists != (receiver.life_at_known_end(id) != 0)) {
				return false;
			}
		}
		return true;
	}

private:
	struct Body {
		bool exists = false;
		bool planar = false;
		int64_t event_tick = -EVENT_INTERVAL; // when it was last added, removed or teleported
		cga::Pose<double> pose;
		cga::Vector3<double> velocity{ 0.0 }; // meters per tick
		double spin = 0.0; // radians per tick
		double growth = 1.0; // factor per tick
		std::map<int64_t, cga::Pose<double>> path; // by tick
	};

	void add(net::Sender &sender, uint32_t id, int64_t tick, Input &input) {
		Body &body = _bodies[id];
		body = Body();
		body.exists = true;
		body.planar = input.flag();
		body.event_tick = tick;
		body.pose = pose_from(input);
		if (body.planar) {
			body.pose = net::BodyState::planar_part(body.pose);
			body.pose.rotation = glm::length(body.pose.rotation) > 1e-3 ? glm::normalize(body.pose.rotation) : cga::Quaternion<double>(1.0, 0.0, 0.0, 0.0);
		}
		require(sender.add_body(id, body.pose, body.planar, double(tick) * TICK), "a body cannot be added");
		body.path[tick] = body.pose;
	}

	static void move(Body &body, int64_t tick) {
		body.pose.translation += body.velocity;
		const cga::Vector3<double> axis = body.planar ? cga::Vector3<double>(0.0, 0.0, 1.0) : cga::Vector3<double>(0.6, 0.0, 0.8);
		body.pose.rotation = glm::normalize(body.pose.rotation * glm::angleAxis(body.spin, axis));
		body.pose.scale = std::clamp(body.pose.scale * body.growth, 0.01, 100.0);
		body.path.erase(body.path.begin(), body.path.lower_bound(tick - 1200));
	}

	void check_pose(const net::Receiver &receiver, uint32_t id, int64_t tick) const {
		const auto shown = receiver.pose_at(id, double(tick) * TICK);
		const auto was = _bodies[id].path.find(tick);
		if (!shown || was == _bodies[id].path.end()) {
			return;
		}
		const net::StreamSettings &settings = receiver.settings();
		const cga::Deviation deviation = cga::deviation(*shown, was->second, 0.0);
		const double distance = deviation.distance / double(float(settings.position_tolerance));
		const double angle = deviation.angle * 57.29577951308232 / double(float(settings.rotation_tolerance));
		const double rounding = 1e-9 * glm::length(was->second.translation) / settings.position_tolerance;
		require(distance <= 1.001 * _relaxation + rounding, "a body deviates by more than the position tolerance", std::to_string(distance) + " of " + std::to_string(settings.position_tolerance) + " m");
		require(angle <= MAX_ANGLE * _relaxation, "a body deviates by more than the rotation tolerance", std::to_string(angle) + " of " + std::to_string(settings.rotation_tolerance) + " degrees");
	}

	std::array<Body, COUNT> _bodies;
	double _relaxation = 1.0; // the largest so far
	uint32_t _snapshots = 0; // that the receiver has decoded
	int64_t _exact_from = 0; // tick
};

} // namespace fuzz
