#pragma once

#include <cstddef>

namespace net {

/// Input of segment_error(): samples as rows with one entry per sample, and a segment's coefficients, in grid steps.
struct SegmentErrorInput {
	static constexpr size_t MAX_SAMPLES = 256;
	using Row = float[MAX_SAMPLES];

	const Row *target; ///< 6 rows: translation and rotation vector from the start of the segment
	const Row *to_body; ///< 9 rows: the rotation matrix from world axes to the body's axes at the sample
	const Row *jacobian; ///< 9 rows: right Jacobian at the sample's rotation vector
	const float *u; ///< fraction of the segment at the sample; 0 in the padding
	const float *w; ///< u (1 - u)
	size_t padded_count; ///< number of samples, rounded up to a multiple of 8
	float end[6];
	float curvature[6];
};

/// The maximum error of the body's center, of the points at the lever arm and of the rotation (see StreamGrid), over all samples, in steps. If it exceeds `limit`,
/// the result may be any lower bound above `limit` (early exit). All machines compute the same bits.
[[nodiscard]] float segment_error(const SegmentErrorInput &input, float limit) noexcept;

/// segment_error() compiled for AVX2, on x86-64 only.
[[nodiscard]] float segment_error_avx2(const SegmentErrorInput &input, float limit) noexcept;

} // namespace net
