#include "cga/algebra/is_blade.hpp"

#include <cmath>

namespace cga {

std::optional<int> single_grade(const Multivector &x, double tolerance) {
	const double size = x.max_abs();
	if (!(size > 0.0) || !x.is_finite()) {
		return std::nullopt;
	}
	std::optional<int> only;
	for (int k = 0; k <= DIMENSION; ++k) {
		if (x.grade(k).max_abs() > tolerance * size) {
			if (only) {
				return std::nullopt;
			}
			only = k;
		}
	}
	return only;
}

bool is_blade(const Multivector &x, double tolerance) {
	if (x == Multivector()) {
		return true;
	}
	const std::optional<int> k = single_grade(x, tolerance);
	if (!k) {
		return false;
	}
	if (*k != 2 && *k != 3) {
		return true;
	}
	const Multivector unit = x.grade(*k).times_power_of_two(-std::ilogb(x.max_abs()));
	const Multivector bivector = *k == 2 ? unit : unit.dual();
	return bivector.outer_product(bivector).max_abs() <= tolerance;
}

} // namespace cga
