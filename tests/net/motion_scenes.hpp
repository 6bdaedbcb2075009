#pragma once

#include "../cga/random_poses.hpp"
#include "net/motion/segment_fit.hpp"

#include <functional>
#include <string>
#include <vector>

// Motions of bodies as functions of time, and the error of shown poses.

namespace net_test {

using cga_test::PI;
using cga_test::PoseD;
using cga_test::QuaternionD;
using cga_test::Vector3D;

using Path = std::function<PoseD(double)>; // of seconds

struct Motion {
	std::string name;
	Path path;
	bool has_kinks = false;
};

inline PoseD turned_at(const Vector3D &position, const Vector3D &axis, double angle, double scale = 1.0) {
	return { position, cga_test::axis_angle(axis, angle), scale };
}

/// The height of a body that falls and bounces on y = 0, with a kink at each bounce.
inline double bounce(double time, double height) {
	double fall = std::sqrt(2.0 * height / 9.81);
	if (time < fall) {
		return height - 0.5 * 9.81 * time * time;
	}
	time -= fall;
	for (double speed = 0.7 * 9.81 * fall; speed > 0.05; speed *= 0.7) {
		const double up = 2.0 * speed / 9.81;
		if (time < up) {
			return speed * time - 0.5 * 9.81 * time * time;
		}
		time -= up;
	}
	return 0.0;
}

/// A pseudorandom number from -1 to 1 that depends only on its arguments.
inline double noise(int64_t index, int axis) {
	uint64_t x = uint64_t(index) * 0x9e3779b97f4a7c15u + uint64_t(axis) * 0xd1b54a32d192ed03u;
	x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
	x = (x ^ x >> 27) * 0x94d049bb133111ebu;
	return double(x >> 11) / 4503599627370496.0 - 1.0;
}

/// Motions of all kinds around a position.
inline std::vector<Motion> motions(const Vector3D &position) {
	const Vector3D y(0.0, 1.0, 0.0);
	const Vector3D tilted(1.0, 2.0, -0.5);
	return {
		{ "rest", [=](double) { return turned_at(position, tilted, 0.3); } },
		{ "line", [=](double t) { return turned_at(position + Vector3D(3.1, -0.2, 1.0) * t, y, 0.7); } },
		{ "parabola", [=](double t) { return turned_at(position + Vector3D(2.0, 5.0, 0.0) * t - y * (4.905 * t * t), tilted, 1.3 * t); } },
		{ "slow spin", [=](double t) { return turned_at(position, tilted, 0.2 * t); } },
		{ "spin", [=](double t) { return turned_at(position, tilted, 6.0 * t); } },
		{ "fast spin", [=](double t) { return turned_at(position, y, 25.0 * t); } },
		{ "tumble", [=](double t) { PoseD pose = turned_at(position, Vector3D(std::cos(t), 1.0, std::sin(2.0 * t)), 4.0 * t); return pose; } },
		{ "wheel", [=](double t) { return turned_at(position + Vector3D(std::cos(3.0 * t), 0.0, std::sin(3.0 * t)) * 2.0, y, -3.0 * t); } },
		{ "bounce", [=](double t) { return turned_at(position + Vector3D(0.5 * t, bounce(t, 2.0), 0.0), tilted, 2.0 * t); }, true },
		{ "collision", [=](double t) { return turned_at(position + Vector3D(t < 0.77 ? 6.0 * t : 4.62 - 3.0 * (t - 0.77), 0.0, 0.0), y, t < 0.77 ? 0.0 : 11.0 * (t - 0.77)); }, true },
		{ "noise", [=](double t) { const int64_t i = std::llround(t * 1000.0); return turned_at(position + Vector3D(noise(i, 0), noise(i, 1), noise(i, 2)) * 0.02, tilted, 0.05 * noise(i, 3)); }, true },
		{ "growth", [=](double t) { return turned_at(position + y * t, y, t, std::exp2(std::sin(2.0 * t))); } },
		{ "small", [=](double t) { return turned_at(position, tilted, 0.5 * t, 0.01); } },
		{ "large", [=](double t) { return turned_at(position + y * t, tilted, 0.5 * t, 4.0); } },
		{ "stop and go", [=](double t) { const double whole = std::floor(t / 0.8); const double rest = t - 0.8 * whole; return turned_at(position + Vector3D(whole + (rest < 0.4 ? rest * 2.5 : 1.0), 0.0, 0.0), y, 0.0); }, true },
	};
}

/// Sample times at a constant rate.
inline std::vector<double> regular_times(double rate, double seconds) {
	std::vector<double> times;
	for (int i = 1; i <= int(seconds * rate + 1e-9); ++i) {
		times.push_back(i / rate);
	}
	return times;
}

/// Sample times at random intervals of 4 to 40 ms.
inline std::vector<double> irregular_times(unsigned seed, double seconds) {
	cga_test::Random random(seed);
	std::vector<double> times;
	for (double t = 0.0; (t += random.uniform(0.004, 0.04)) <= seconds;) {
		times.push_back(t);
	}
	return times;
}

/// The error that a stream bounds, relative to the tolerance: the maximum deviation of the center and of the points on the
/// axes at the lever arm, plus the deviation that the error of the scale causes there.
inline double error_share(const PoseD &shown, const PoseD &truth, const net::StreamGrid &grid) {
	const Vector3D offset = shown.translation - truth.translation;
	double worst = glm::length(offset);
	for (const Vector3D &axis : { Vector3D(1, 0, 0), Vector3D(0, 1, 0), Vector3D(0, 0, 1) }) {
		worst = std::max(worst, glm::length(offset + grid.lever_arm * (shown.rotation * axis - truth.rotation * axis)));
	}
	worst += grid.lever_arm * std::abs(shown.scale - truth.scale);
	return worst / (net::StreamGrid::TOLERANCE * grid.position_step);
}

} // namespace net_test
