#include "net/coding/range_coder.hpp"

#include <array>
#include <cmath>

namespace net {

const uint16_t *CostMeter::table() {
	static const std::array<uint16_t, 257> COSTS = [] {
		std::array<uint16_t, 257> values{};
		for (int i = 1; i <= 256; ++i) {
			values[size_t(i)] = uint16_t(std::lround(-256.0 * std::log2(i / 256.0)));
		}
		values[0] = values[1];
		return values;
	}();
	return COSTS.data();
}

} // namespace net
