#include "net/coding/quantization.hpp"

namespace net {

namespace {

constexpr double SQRT_HALF = 0.70710678118654752440;

/// The maximum level n. Levels -n to n are stored as 0 to 2n.
uint32_t half_range(int bits) {
	return (uint32_t(1) << (bits - 1)) - 1;
}

} // namespace

SmallestThree quantize_rotor(const glm::quat &q, int bits) {
	const double c[4] = { q.x, q.y, q.z, q.w };
	SmallestThree code;
	for (uint32_t i = 1; i < 4; ++i) {
		if (std::abs(c[i]) > std::abs(c[code.dropped])) {
			code.dropped = i;
		}
	}
	const double sign = c[code.dropped] < 0 ? -1.0 : 1.0;
	const double n = half_range(bits);
	int slot = 0;
	for (uint32_t i = 0; i < 4; ++i) {
		if (i != code.dropped) {
			const double level = std::round(sign * c[i] / SQRT_HALF * n);
			code.level[slot++] = uint32_t(std::fmin(std::fmax(level, -n), n) + n);
		}
	}
	return code;
}

std::optional<glm::quat> dequantize_rotor(const SmallestThree &code, int bits) {
	const double n = half_range(bits);
	double c[4] = { 0, 0, 0, 0 };
	double dropped_squared = 1.0;
	int slot = 0;
	for (uint32_t i = 0; i < 4; ++i) {
		if (i != code.dropped) {
			if (code.level[slot] > 2 * half_range(bits)) {
				return std::nullopt;
			}
			c[i] = (double(code.level[slot++]) - n) / n * SQRT_HALF;
			dropped_squared -= c[i] * c[i];
		}
	}
	if (dropped_squared < 0) {
		return std::nullopt;
	}
	c[code.dropped] = std::sqrt(dropped_squared);
	return glm::quat(float(c[3]), float(c[0]), float(c[1]), float(c[2]));
}

std::optional<int32_t> quantize_scale(float scale) {
	if (!(scale > 0) || !std::isfinite(scale)) {
		return std::nullopt;
	}
	const double level = std::round(portable_log2(double(scale)) * SCALE_LEVELS_PER_OCTAVE);
	if (std::abs(level) > MAX_SCALE_LEVEL) {
		return std::nullopt;
	}
	return int32_t(level);
}

} // namespace net
