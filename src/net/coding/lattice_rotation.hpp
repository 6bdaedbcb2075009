#pragma once

#include "cga/vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace net {

/// A unit quaternion as its three smallest components, quantized to 2^-17 (8 microradians). All machines dequantize it to
/// the same doubles.
struct LatticeRotation {
	static constexpr int BITS = 18; ///< bits per level, including the sign
	static constexpr double STEPS = 131072.0;
	static constexpr int32_t MAX_LEVEL = 92690; ///< slightly above sqrt(1/2)

	uint8_t dropped = 3; ///< index in (x, y, z, w) of the largest component, which is positive and not stored
	int32_t level[3] = { 0, 0, 0 }; ///< the other components times STEPS

	[[nodiscard]] static LatticeRotation nearest(const cga::Quaternion<double> &q) {
		const double c[4] = { q.x, q.y, q.z, q.w };
		LatticeRotation result;
		for (int i = 2; i >= 0; --i) {
			if (std::fabs(c[i]) > std::fabs(c[result.dropped])) {
				result.dropped = uint8_t(i);
			}
		}
		const double sign = c[result.dropped] < 0.0 ? -STEPS : STEPS;
		for (int i = 0, slot = 0; i < 4; ++i) {
			if (i != result.dropped) {
				result.level[slot++] = int32_t(std::floor(sign * c[i] + 0.5));
			}
		}
		return result;
	}

	/// False if no unit quaternion has these components.
	[[nodiscard]] bool is_valid() const {
		return dropped < 4 && std::all_of(level, level + 3, [](int32_t value) { return value >= -MAX_LEVEL && value <= MAX_LEVEL; }) && dropped_squared() > 0.0;
	}

	[[nodiscard]] cga::Quaternion<double> value() const {
		double c[4];
		for (int i = 0, slot = 0; i < 4; ++i) {
			c[i] = i == dropped ? std::sqrt(dropped_squared()) : double(level[slot++]) / STEPS;
		}
		return cga::Quaternion<double>(c[3], c[0], c[1], c[2]);
	}

private:
	[[nodiscard]] double dropped_squared() const {
		double sum = 1.0;
		for (const int32_t value : level) {
			const double component = double(value) / STEPS;
			sum -= component * component;
		}
		return sum;
	}
};

} // namespace net
