#pragma once

#include "cga/batch/pose_block.hpp"

// Quaternions (w, x, y, z) and vectors of one lane of a block's rows.

namespace cga {

inline void store_lane(PoseBlock::Row (&rows)[4], int lane, const Quaternion<float> &quaternion) noexcept {
	rows[0][lane] = quaternion.w;
	rows[1][lane] = quaternion.x;
	rows[2][lane] = quaternion.y;
	rows[3][lane] = quaternion.z;
}

inline void store_lane(PoseBlock::Row (&rows)[3], int lane, const Vector3<float> &vector) noexcept {
	rows[0][lane] = vector.x;
	rows[1][lane] = vector.y;
	rows[2][lane] = vector.z;
}

[[nodiscard]] inline Quaternion<float> load_lane(const PoseBlock::Row (&rows)[4], int lane) noexcept {
	return { rows[0][lane], rows[1][lane], rows[2][lane], rows[3][lane] };
}

[[nodiscard]] inline Vector3<float> load_lane(const PoseBlock::Row (&rows)[3], int lane) noexcept {
	return { rows[0][lane], rows[1][lane], rows[2][lane] };
}

} // namespace cga
