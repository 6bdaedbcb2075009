#include "cga/text/readable.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cga {

// Components below this fraction of the vector are rounding errors of zero.
static constexpr double ROUNDING = 1e-12;

std::string readable(double value) {
	char text[32];
	std::snprintf(text, sizeof(text), "%.6g", value == 0.0 ? 0.0 : value);
	return text;
}

std::string readable(const Vector3<double> &vector, double size) {
	const double rounding = ROUNDING * std::max({ std::abs(vector.x), std::abs(vector.y), std::abs(vector.z), size });
	const auto component = [rounding](double value) { return readable(std::abs(value) < rounding ? 0.0 : value); };
	return "(" + component(vector.x) + ", " + component(vector.y) + ", " + component(vector.z) + ")";
}

} // namespace cga
