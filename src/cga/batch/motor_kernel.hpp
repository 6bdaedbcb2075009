#pragma once

#include "cga/batch/lane_access.hpp"
#include "cga/batch/motor_block.hpp"

#include <math.h>

// The kernels of motors, for one block (pose_kernel.hpp has those of pose pairs).

namespace cga::kernel {

namespace {

CGA_ALWAYS_INLINE LaneQuaternion sum(const LaneQuaternion &p, const LaneQuaternion &q) noexcept {
	return { p.w + q.w, p.x + q.x, p.y + q.y, p.z + q.z };
}

CGA_ALWAYS_INLINE LaneQuaternion scaled(const LaneQuaternion &q, float factor) noexcept {
	return { q.w * factor, q.x * factor, q.y * factor, q.z * factor };
}

CGA_ALWAYS_INLINE float squared(const LaneQuaternion &q) noexcept {
	return (q.w * q.w + q.x * q.x) + (q.y * q.y + q.z * q.z);
}

// The vector part of p conj(q).
CGA_ALWAYS_INLINE LaneVector vector_of_quotient(const LaneQuaternion &p, const LaneQuaternion &q) noexcept {
	return {
		p.x * q.w - p.w * q.x - p.y * q.z + p.z * q.y,
		p.y * q.w - p.w * q.y - p.z * q.x + p.x * q.z,
		p.z * q.w - p.w * q.z - p.x * q.y + p.y * q.x,
	};
}

// 1 / x, and 0 where x is 0.
CGA_ALWAYS_INLINE float inverse_or_zero(float x) noexcept {
	const bool is_zero = x == 0.0f;
	return (is_zero ? 0.0f : 1.0f) / (is_zero ? 1.0f : x);
}

// M1 M2 = (a1 a2, b1 b2, b1 v2 + v1 a2)
CGA_ALWAYS_INLINE void compose_block(const MotorBlock &first, const MotorBlock &second, MotorBlock &products) noexcept {
	CGA_INDEPENDENT_ITERATIONS
	for (int lane = 0; lane < PoseBlock::LANES; ++lane) {
		const LaneQuaternion b1 = load_lane(first.b, lane);
		const LaneQuaternion a2 = load_lane(second.a, lane);
		const LaneQuaternion a = product(load_lane(first.a, lane), a2);
		const LaneQuaternion v = sum(product(b1, load_lane(second.v, lane)), product(load_lane(first.v, lane), a2));
		store_lane(products.b, lane, product(b1, load_lane(second.b, lane)));
		store_lane(products.a, lane, a);
		store_lane(products.v, lane, v);
	}
}

// x, y, z of 8 points.
using PointColumns = PoseBlock::Row[3];

// t + s q x q* = (b x - 2 v) conj(a) / |a|^2
CGA_ALWAYS_INLINE void transform_block(const MotorBlock &motors, PointColumns &points) noexcept {
	CGA_INDEPENDENT_ITERATIONS
	for (int lane = 0; lane < PoseBlock::LANES; ++lane) {
		const LaneQuaternion a = load_lane(motors.a, lane);
		const LaneQuaternion point = { 0.0f, points[0][lane], points[1][lane], points[2][lane] };
		const LaneQuaternion image = sum(product(load_lane(motors.b, lane), point), scaled(load_lane(motors.v, lane), -2.0f));
		const LaneVector direction = vector_of_quotient(image, a);
		const float inverse = inverse_or_zero(squared(a));
		store_lane(points, lane, LaneVector{ direction.x * inverse, direction.y * inverse, direction.z * inverse });
	}
}

// q = a, s = |b| / |a|, t = -2 v conj(a) / |a|^2
CGA_ALWAYS_INLINE void extract_block(const MotorBlock &motors, RowColumns &columns) noexcept {
	for (int lane = 0; lane < PoseBlock::LANES; ++lane) {
		const LaneQuaternion a = load_lane(motors.a, lane);
		const float inverse = inverse_or_zero(squared(a));
		const float scale = sqrtf(squared(load_lane(motors.b, lane)) * inverse);
		const LaneVector origin = vector_of_quotient(scaled(load_lane(motors.v, lane), -2.0f * inverse), a);
		store_pose(columns, lane, a, inverse, scale, origin);
	}
}

// With R the basis divided by its scale s, 4 q q^T is symmetric with
//   4 w^2 = 1 + R11 + R22 + R33     4 x^2 = 1 + R11 - R22 - R33     and so on
//   4 w x = R32 - R23               4 x y = R21 + R12               and so on
// Row i with the largest diagonal entry is 4 q_i q with |q_i| >= 1/2, and loses no digits to cancellation.
//   a = q / sqrt(s)     b = q sqrt(s)     v = -(1/2) t a
CGA_ALWAYS_INLINE void motors_from_columns(const RowColumns &columns, MotorBlock &motors) noexcept {
	for (int lane = 0; lane < PoseBlock::LANES; ++lane) {
		const float r11 = columns[0][lane], r12 = columns[1][lane], r13 = columns[2][lane];
		const float r21 = columns[4][lane], r22 = columns[5][lane], r23 = columns[6][lane];
		const float r31 = columns[8][lane], r32 = columns[9][lane], r33 = columns[10][lane];
		// The mean of the squared lengths of the axes.
		const float squares = ((r11 * r11 + r12 * r12 + r13 * r13) + (r21 * r21 + r22 * r22 + r23 * r23)) + (r31 * r31 + r32 * r32 + r33 * r33);
		const float scale = sqrtf(squares * (1.0f / 3.0f));

		const float ww = scale + (r11 + r22 + r33);
		const float xx = scale + (r11 - r22 - r33);
		const float yy = scale + (r22 - r11 - r33);
		const float zz = scale + (r33 - r11 - r22);
		const float wx = r32 - r23, wy = r13 - r31, wz = r21 - r12;
		const float xy = r21 + r12, xz = r13 + r31, yz = r32 + r23;

		LaneQuaternion q = { ww, wx, wy, wz };
		float largest = ww;
		const bool x_is_larger = xx > largest;
		q = x_is_larger ? LaneQuaternion{ wx, xx, xy, xz } : q;
		largest = x_is_larger ? xx : largest;
		const bool y_is_larger = yy > largest;
		q = y_is_larger ? LaneQuaternion{ wy, xy, yy, yz } : q;
		largest = y_is_larger ? yy : largest;
		q = zz > largest ? LaneQuaternion{ wz, xz, yz, zz } : q;

		const float root = sqrtf(scale);
		const float size = sqrtf(squared(q));
		const LaneQuaternion b = scaled(q, root * inverse_or_zero(size));
		const LaneQuaternion a = scaled(q, inverse_or_zero(root * size));
		const LaneQuaternion half = { 0.0f, -0.5f * columns[3][lane], -0.5f * columns[7][lane], -0.5f * columns[11][lane] };
		store_lane(motors.a, lane, a);
		store_lane(motors.b, lane, b);
		store_lane(motors.v, lane, product(half, a));
	}
}

} // namespace

} // namespace cga::kernel
