#pragma once

#include "../input.hpp"

#include "cga/motor/pose.hpp"

#include <glm/geometric.hpp>

#include <cmath>

// Poses for the fuzz targets of src/net.

namespace fuzz {

constexpr double TICK = 1.0 / 60.0;

inline void require_finite(const cga::Pose<double> &pose) {
	const double sum = pose.translation.x + pose.translation.y + pose.translation.z + pose.rotation.w + pose.rotation.x + pose.rotation.y + pose.rotation.z + pose.scale;
	require(std::isfinite(sum) && pose.scale > 0.0, "a pose is not finite");
}

/// The motion of a body.
inline cga::Pose<double> pose_at(uint32_t id, double time) {
	cga::Pose<double> pose;
	pose.translation = cga::Vector3<double>(double(id) + std::sin(time * (1.0 + id)), std::fabs(std::sin(3.0 * time)), 0.1 * time);
	pose.rotation = glm::angleAxis(2.0 * time * id, cga::Vector3<double>(0.6, 0.0, 0.8));
	return pose;
}

/// A valid pose.
inline cga::Pose<double> pose_from(Input &input) {
	static constexpr double RANGES[] = { 1.0, 100.0, 1e4, 1e7 };
	const double range = RANGES[input.byte() % 4];
	cga::Pose<double> pose;
	pose.translation = { input.between(-range, range), input.between(-range, range), input.between(-range, range) };
	const cga::Quaternion<double> rotation(input.between(-1.0, 1.0), input.between(-1.0, 1.0), input.between(-1.0, 1.0), input.between(-1.0, 1.0));
	pose.rotation = glm::length(rotation) > 1e-3 ? glm::normalize(rotation) : cga::Quaternion<double>(1.0, 0.0, 0.0, 0.0);
	pose.scale = input.flag() ? std::exp(input.between(-3.0, 3.0)) : 1.0;
	return pose;
}

/// A pose of any numbers.
inline cga::Pose<double> any_pose_from(Input &input) {
	cga::Pose<double> pose;
	pose.translation = { input.number(), input.number(), input.number() };
	pose.rotation = { input.number(), input.number(), input.number(), input.number() };
	pose.scale = input.number();
	return pose;
}

} // namespace fuzz
