// The source of segment_error(), compiled for the baseline and for AVX2. It must not call external inline functions, for the
// reason in cga/batch/kernels.hpp.

#include "net/motion/segment_error.hpp"

#include <math.h>

namespace net {

namespace {

inline float max_error(const SegmentErrorInput &input, float limit) noexcept {
	// By reference: copies would be loaded as vectors right after the caller has stored scalars, which stalls.
	const float(&end)[6] = input.end;
	const float(&curvature)[6] = input.curvature;
	const SegmentErrorInput::Row *const target = input.target;
	const SegmentErrorInput::Row *const to_body = input.to_body;
	const SegmentErrorInput::Row *const jacobian = input.jacobian;
	float lane_max[8] = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f };
	for (size_t block = 0; block < input.padded_count; block += 8) {
		for (size_t lane = 0; lane < 8; ++lane) {
			const size_t k = block + lane;
			const float u = input.u[k];
			const float w = input.w[k];
			const float x = target[0][k] - end[0] * u - curvature[0] * w;
			const float y = target[1][k] - end[1] * u - curvature[1] * w;
			const float z = target[2][k] - end[2] * u - curvature[2] * w;
			const float a = target[3][k] - end[3] * u - curvature[3] * w;
			const float b = target[4][k] - end[4] * u - curvature[4] * w;
			const float c = target[5][k] - end[5] * u - curvature[5] * w;
			const float bx = to_body[0][k] * x + to_body[1][k] * y + to_body[2][k] * z;
			const float by = to_body[3][k] * x + to_body[4][k] * y + to_body[5][k] * z;
			const float bz = to_body[6][k] * x + to_body[7][k] * y + to_body[8][k] * z;
			const float ra = jacobian[0][k] * a + jacobian[1][k] * b + jacobian[2][k] * c;
			const float rb = jacobian[3][k] * a + jacobian[4][k] * b + jacobian[5][k] * c;
			const float rc = jacobian[6][k] * a + jacobian[7][k] * b + jacobian[8][k] * c;
			// The center, and the center plus r x e_i: at the lever arm, a step of rotation is a step of position.
			const float xx = bx * bx;
			const float yy = by * by;
			const float zz = bz * bz;
			const float e0 = xx + yy + zz;
			const float e1 = xx + (by + rc) * (by + rc) + (bz - rb) * (bz - rb);
			const float e2 = (bx - rc) * (bx - rc) + yy + (bz + ra) * (bz + ra);
			const float e3 = (bx + rb) * (bx + rb) + (by - ra) * (by - ra) + zz;
			const float m1 = e0 > e1 ? e0 : e1;
			const float m2 = e2 > e3 ? e2 : e3;
			// See StreamGrid: |r| within the rotation tolerance.
			const float e4 = (ra * ra + rb * rb + rc * rc) * (2.0f / 3.0f);
			const float m3 = m1 > m2 ? m1 : m2;
			const float m = m3 > e4 ? m3 : e4;
			const float squared = u > 0.0f ? m : 0.0f; // u is 0 in the padding
			lane_max[lane] = lane_max[lane] > squared ? lane_max[lane] : squared;
		}
		float max_squared = lane_max[0];
		for (size_t lane = 1; lane < 8; ++lane) {
			max_squared = max_squared < lane_max[lane] ? lane_max[lane] : max_squared;
		}
		if (max_squared > limit * limit || block + 8 >= input.padded_count) {
			return sqrtf(max_squared);
		}
	}
	return 0.0f;
}

} // namespace

} // namespace net
