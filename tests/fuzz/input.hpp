#pragma once

#include "mutation.hpp"

#include "cga/motor/pose.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

// Common code of the fuzz targets of src/net.

namespace fuzz {

constexpr double TICK = 1.0 / 60.0;

inline void require(bool condition, const char *failure) {
	if (!condition) {
		std::fprintf(stderr, "net_fuzz: %s\n", failure);
		std::abort();
	}
}

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

/// Splits an input into pieces: a length of two bytes, little-endian, then as many bytes, or all that are left.
struct Pieces {
	const uint8_t *bytes;
	size_t size;

	bool next(Bytes &piece) {
		if (size < 2) {
			return false;
		}
		const size_t count = std::min<size_t>(bytes[0] | size_t(bytes[1]) << 8, size - 2);
		piece.assign(bytes + 2, bytes + 2 + count);
		bytes += 2 + count;
		size -= 2 + count;
		return true;
	}
};

} // namespace fuzz
