#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/motor/pose.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>

// Random elements from a fixed seed, and distances between poses, for the tests of src/cga.

namespace cga_test {

inline constexpr double PI = 3.14159265358979323846;

using PoseD = cga::Pose<double>;
using Vector3D = cga::Vector3<double>;
using QuaternionD = cga::Quaternion<double>;

class Random {
public:
	explicit Random(unsigned seed) :
			_engine(seed) {}

	double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(_engine); }
	double normal() { return std::normal_distribution<double>()(_engine); }
	Vector3D vector(double size) { return Vector3D(normal(), normal(), normal()) * size; }
	QuaternionD rotation() { return glm::normalize(QuaternionD(normal(), normal(), normal(), normal())); }
	// Scales 0.01 to 100, evenly in the logarithm.
	double scale() { return std::pow(10.0, uniform(-2.0, 2.0)); }
	PoseD pose(double distance = 10.0) { return { vector(distance), rotation(), scale() }; }
	PoseD rigid_pose(double distance = 10.0) { return { vector(distance), rotation(), 1.0 }; }

	cga::Multivector multivector() {
		cga::Multivector result;
		for (int index = 0; index < cga::BLADE_COUNT; ++index) {
			result[index] = normal();
		}
		return result;
	}

private:
	std::mt19937_64 _engine;
};

inline QuaternionD axis_angle(const Vector3D &axis, double angle) {
	const Vector3D sines = glm::normalize(axis) * std::sin(angle / 2.0);
	return { std::cos(angle / 2.0), sines.x, sines.y, sines.z };
}

// The angle between two rotations, ignoring their signs.
inline double angle_between(const QuaternionD &left, const QuaternionD &right) {
	const QuaternionD rotation = left * glm::conjugate(right);
	return 2.0 * std::atan2(glm::length(cga::vector_part(rotation)), std::abs(rotation.w));
}

// The maximum of the angle, the relative difference of scale and the distance relative to the positions.
inline double difference(const PoseD &left, const PoseD &right) {
	const double size = std::max({ 1.0, glm::length(left.translation), glm::length(right.translation) });
	return std::max({ angle_between(left.rotation, right.rotation), std::abs(left.scale / right.scale - 1.0),
			glm::length(left.translation - right.translation) / size });
}

inline Vector3D transformed(const PoseD &pose, const Vector3D &point) {
	return pose.translation + pose.scale * (pose.rotation * point);
}

template <class T>
bool is_finite(const cga::Pose<T> &pose) {
	for (int axis = 0; axis < 3; ++axis) {
		if (!std::isfinite(pose.translation[axis])) {
			return false;
		}
	}
	return std::isfinite(pose.rotation.w) && std::isfinite(pose.rotation.x) && std::isfinite(pose.rotation.y) &&
			std::isfinite(pose.rotation.z) && std::isfinite(pose.scale);
}

} // namespace cga_test
