#pragma once

#include "net/coding/portable_math.hpp"

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <cstdint>
#include <optional>

namespace net {

/// Maximum error of a decoded pose.
struct Tolerance {
	float position = 0.002f; ///< meters, Euclidean
	float rotation = 0.25f; ///< degrees, angle between the encoded and the decoded rotation
};

/// The quantization step h of positions. Half the diagonal of a grid cell, sqrt(3) h / 2, equals `tolerance`.
[[nodiscard]] inline float position_step(float tolerance) {
	return 2.0f / std::sqrt(3.0f) * tolerance;
}

/// A unit quaternion as its three smallest components.
///
/// The largest component is made positive and restored from |q| = 1. The others lie in [-1/sqrt(2), 1/sqrt(2)] and
/// are quantized to `bits` each with the step h = sqrt(2) / (2^bits - 2). The number of levels is odd, so that 0 is exact.
/// With an error of at most h/2 in each, the error of the dropped component is at most 3 h/2 and that of the rotation at most
/// 2 sqrt(3) h, from which `rotor_bits` follows.
struct SmallestThree {
	uint32_t dropped = 0; ///< index in (x, y, z, w) of the largest component
	uint32_t level[3] = { 0, 0, 0 };
};

inline constexpr int MIN_ROTOR_BITS = 4;
inline constexpr int MAX_ROTOR_BITS = 24;

/// Bits per component for a tolerance in CODEC_ROTATION_TOLERANCE_RANGE.
[[nodiscard]] inline int rotor_bits(float tolerance_degrees) {
	const double radians = double(tolerance_degrees) * 3.14159265358979323846 / 180.0;
	const double levels = 2.0 * std::sqrt(6.0) / radians + 2.0;
	int bits = MIN_ROTOR_BITS;
	while (std::ldexp(1.0, bits) < levels) {
		++bits;
	}
	return bits;
}

/// `q` must have unit length.
[[nodiscard]] SmallestThree quantize_rotor(const glm::quat &q, int bits);
/// Returns std::nullopt if no unit quaternion has these three components.
[[nodiscard]] std::optional<glm::quat> dequantize_rotor(const SmallestThree &code, int bits);

/// The log2 of a scale is quantized in steps of 1/4096: range 2^-16 to 2^16, relative error at most 8.5e-5.
inline constexpr int SCALE_BITS = 17;
inline constexpr double SCALE_LEVELS_PER_OCTAVE = 4096.0;
inline constexpr int32_t MAX_SCALE_LEVEL = (1 << (SCALE_BITS - 1)) - 1;

/// Returns std::nullopt if the scale is not positive or out of range.
[[nodiscard]] std::optional<int32_t> quantize_scale(float scale);
[[nodiscard]] inline float dequantize_scale(int32_t level) {
	return float(portable_exp2(level / SCALE_LEVELS_PER_OCTAVE));
}

} // namespace net
