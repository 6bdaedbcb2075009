#pragma once

#include <cstddef>

namespace net {

/// What the error of a segment's code is computed from: rows with one entry for each sample, in steps of the grid.
struct SegmentErrorInput {
	static constexpr size_t MAX_SAMPLES = 256;
	using Row = float[MAX_SAMPLES];

	const Row *target; ///< 6 rows: translation and rotation vector from the start
	const Row *to_body; ///< 9 rows: the world's axes to the body's
	const Row *jacobian; ///< 9 rows: a change of the rotation vector to the body's rotation
	const float *u; ///< the sample's fraction of the segment; 0 beyond the last sample
	const float *w; ///< u (1 - u)
	size_t padded_count; ///< a multiple of 8
	float displacement[6];
	float curvature[6];
};

/// The largest error of a sample, in steps: of the center, and of points at the lever arm. Stops early above `limit`.
/// The same bits on every machine.
[[nodiscard]] float segment_error(const SegmentErrorInput &input, float limit) noexcept;

/// segment_error() compiled for AVX2, on x86-64 only.
[[nodiscard]] float segment_error_avx2(const SegmentErrorInput &input, float limit) noexcept;

} // namespace net
