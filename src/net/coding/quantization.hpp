#pragma once

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <cstdint>
#include <optional>

namespace net {

/// Largest error a receiver may see in one decoded pose.
struct Tolerance {
	float position = 0.002f; ///< metres, Euclidean
	float rotation = 0.25f; ///< degrees, angle of the rotation between sent and received
};

/// The grid on which a point of space is at most `tolerance` from a node:
/// half the diagonal of a cell of side h is sqrt(3) h / 2.
[[nodiscard]] inline float position_step(float tolerance) {
	return 2.0f / std::sqrt(3.0f) * tolerance;
}

/// A unit quaternion by its three components of smallest magnitude.
///
/// The largest one, at least 1/2 and made positive, follows from |q| = 1; the
/// others lie in [-1/sqrt(2), 1/sqrt(2)] and are coded in `bits` each with the
/// step h = sqrt(2) / (2^bits - 2), an odd number of levels so that 0 is exact.
/// With |error| <= h/2 in each, the dropped one is off by at most 3 h/2 and the
/// rotation by at most 2 sqrt(3) h: `rotor_bits` inverts that.
struct SmallestThree {
	uint32_t dropped = 0; ///< index of the largest component in (x, y, z, w)
	uint32_t level[3] = { 0, 0, 0 };
};

inline constexpr int MIN_ROTOR_BITS = 4;
inline constexpr int MAX_ROTOR_BITS = 24;
/// 2 sqrt(6) / (2^24 - 2) radians; below it float32 itself is too coarse.
inline constexpr float MIN_ROTATION_TOLERANCE = 1.7e-5f; ///< degrees

/// `tolerance_degrees` >= MIN_ROTATION_TOLERANCE.
[[nodiscard]] inline int rotor_bits(float tolerance_degrees) {
	const double radians = double(tolerance_degrees) * 3.14159265358979323846 / 180.0;
	const double levels = 2.0 * std::sqrt(6.0) / radians + 2.0;
	const int bits = int(std::ceil(std::log2(levels)));
	return bits < MIN_ROTOR_BITS ? MIN_ROTOR_BITS : bits;
}

/// `q` of unit length.
[[nodiscard]] SmallestThree quantize_rotor(const glm::quat &q, int bits);
/// Empty where no unit quaternion has these three components.
[[nodiscard]] std::optional<glm::quat> dequantize_rotor(const SmallestThree &code, int bits);

/// Scale as log2 in steps of 1/4096: relative error at most 8.5e-5 over 2^-16 .. 2^16.
inline constexpr int SCALE_BITS = 17;
inline constexpr double SCALE_LEVELS_PER_OCTAVE = 4096.0;
inline constexpr int32_t MAX_SCALE_LEVEL = (1 << (SCALE_BITS - 1)) - 1;

/// Empty where the scale is not positive or out of range.
[[nodiscard]] std::optional<int32_t> quantize_scale(float scale);
[[nodiscard]] float dequantize_scale(int32_t level);

} // namespace net
