#include "playground/handles/steps.hpp"

#include <algorithm>
#include <cmath>

namespace playground::handles {

double rounded(double value, double step) {
	const double multiple = step > 0.0 ? std::round(value / step) * step : value;
	return std::isfinite(multiple) ? multiple : value;
}

Vector rounded(const Vector &vector, double step) {
	return { rounded(vector.x, step), rounded(vector.y, step), rounded(vector.z, step) };
}

Vector rounded_direction(const Vector &direction, double step) {
	if (!(step > 0.0)) {
		return direction;
	}
	constexpr double DECIMALS = 1e-4;
	const double up = rounded(std::asin(std::clamp(direction.y, -1.0, 1.0)), step);
	const double around = rounded(std::atan2(direction.x, direction.z), step);
	return rounded(Vector(std::cos(up) * std::sin(around), std::sin(up), std::cos(up) * std::cos(around)), DECIMALS);
}

} // namespace playground::handles
