// The source of segment_error(), compiled for the baseline and for AVX2 (cga/batch/kernels.hpp says why no external inline
// function may be called here).

#include "net/motion/segment_error.hpp"

#include <math.h>

namespace net {

namespace {

inline float largest_error(const SegmentErrorInput &input, float limit) noexcept {
	// By reference: copies would be loaded as vectors right after the caller has stored scalars, which stalls.
	const float(&way)[6] = input.way;
	const float(&bend)[6] = input.bend;
	const SegmentErrorInput::Row *const target = input.target;
	const SegmentErrorInput::Row *const to_body = input.to_body;
	const SegmentErrorInput::Row *const jacobian = input.jacobian;
	float worst[8] = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f };
	for (size_t block = 0; block < input.padded_count; block += 8) {
		for (size_t lane = 0; lane < 8; ++lane) {
			const size_t k = block + lane;
			const float u = input.u[k];
			const float w = input.w[k];
			const float x = target[0][k] - way[0] * u - bend[0] * w;
			const float y = target[1][k] - way[1] * u - bend[1] * w;
			const float z = target[2][k] - way[2] * u - bend[2] * w;
			const float a = target[3][k] - way[3] * u - bend[3] * w;
			const float b = target[4][k] - way[4] * u - bend[4] * w;
			const float c = target[5][k] - way[5] * u - bend[5] * w;
			const float bx = to_body[0][k] * x + to_body[1][k] * y + to_body[2][k] * z;
			const float by = to_body[3][k] * x + to_body[4][k] * y + to_body[5][k] * z;
			const float bz = to_body[6][k] * x + to_body[7][k] * y + to_body[8][k] * z;
			const float ra = jacobian[0][k] * a + jacobian[1][k] * b + jacobian[2][k] * c;
			const float rb = jacobian[3][k] * a + jacobian[4][k] * b + jacobian[5][k] * c;
			const float rc = jacobian[6][k] * a + jacobian[7][k] * b + jacobian[8][k] * c;
			// The center, and the center plus r x e_i: the lever arm turns a step of rotation into one of position.
			const float xx = bx * bx;
			const float yy = by * by;
			const float zz = bz * bz;
			const float e0 = xx + yy + zz;
			const float e1 = xx + (by + rc) * (by + rc) + (bz - rb) * (bz - rb);
			const float e2 = (bx - rc) * (bx - rc) + yy + (bz + ra) * (bz + ra);
			const float e3 = (bx + rb) * (bx + rb) + (by - ra) * (by - ra) + zz;
			const float m1 = e0 > e1 ? e0 : e1;
			const float m2 = e2 > e3 ? e2 : e3;
			const float m = m1 > m2 ? m1 : m2;
			const float counted = u > 0.0f ? m : 0.0f; // beyond the segment u is 0
			worst[lane] = worst[lane] > counted ? worst[lane] : counted;
		}
		float largest = worst[0];
		for (size_t lane = 1; lane < 8; ++lane) {
			largest = largest < worst[lane] ? worst[lane] : largest;
		}
		if (largest > limit * limit || block + 8 >= input.padded_count) {
			return sqrtf(largest);
		}
	}
	return 0.0f;
}

} // namespace

} // namespace net
