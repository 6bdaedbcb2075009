#pragma once

#include "cga/batch/row_columns.hpp"

// The quaternion and the vector of one lane (one body) of a block. The kernels use these types instead of GLM's, whose inline
// functions they must not call (kernels.hpp).

namespace cga::kernel {

namespace {

struct LaneQuaternion {
	float w, x, y, z;
};

struct LaneVector {
	float x, y, z;
};

template <class Quaternion = LaneQuaternion>
CGA_ALWAYS_INLINE Quaternion load_lane(const PoseBlock::Row (&rows)[4], int lane) noexcept {
	return { rows[0][lane], rows[1][lane], rows[2][lane], rows[3][lane] };
}

template <class Vector = LaneVector>
CGA_ALWAYS_INLINE Vector load_lane(const PoseBlock::Row (&rows)[3], int lane) noexcept {
	return { rows[0][lane], rows[1][lane], rows[2][lane] };
}

template <class Quaternion>
CGA_ALWAYS_INLINE void store_lane(PoseBlock::Row (&rows)[4], int lane, const Quaternion &quaternion) noexcept {
	rows[0][lane] = quaternion.w;
	rows[1][lane] = quaternion.x;
	rows[2][lane] = quaternion.y;
	rows[3][lane] = quaternion.z;
}

template <class Vector>
CGA_ALWAYS_INLINE void store_lane(PoseBlock::Row (&rows)[3], int lane, const Vector &vector) noexcept {
	rows[0][lane] = vector.x;
	rows[1][lane] = vector.y;
	rows[2][lane] = vector.z;
}

CGA_ALWAYS_INLINE LaneQuaternion product(const LaneQuaternion &p, const LaneQuaternion &q) noexcept {
	return {
		p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z,
		p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
		p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x,
		p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w,
	};
}

// Writes the row of x -> origin + s R(q) x, with `inverse_square` = 1 / |q|^2.
CGA_ALWAYS_INLINE void store_pose(RowColumns &columns, int lane, const LaneQuaternion &q, float inverse_square, float scale, const LaneVector &origin) noexcept {
	const float twice = 2.0f * scale * inverse_square;
	const float x = twice * q.x;
	const float y = twice * q.y;
	const float z = twice * q.z;
	columns[0][lane] = (scale - y * q.y) - z * q.z;
	columns[1][lane] = x * q.y - z * q.w;
	columns[2][lane] = x * q.z + y * q.w;
	columns[3][lane] = origin.x;
	columns[4][lane] = x * q.y + z * q.w;
	columns[5][lane] = (scale - x * q.x) - z * q.z;
	columns[6][lane] = y * q.z - x * q.w;
	columns[7][lane] = origin.y;
	columns[8][lane] = x * q.z - y * q.w;
	columns[9][lane] = y * q.z + x * q.w;
	columns[10][lane] = (scale - x * q.x) - y * q.y;
	columns[11][lane] = origin.z;
}

} // namespace

} // namespace cga::kernel
