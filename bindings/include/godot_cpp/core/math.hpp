#pragma once

#include <godot_cpp/core/defs.hpp>

#include <cmath>

namespace godot {

// The engine's tolerance of approximate comparisons.
#define CMP_EPSILON 0.00001

namespace Math {

template <typename T>
bool is_finite(T p_value) {
	return std::isfinite(p_value);
}

// The tolerance is relative to the left value, as in the engine.
template <typename T>
bool is_equal_approx(T p_left, T p_right) {
	if (p_left == p_right) {
		return true;
	}
	const T tolerance = static_cast<T>(CMP_EPSILON) * std::abs(p_left);
	return std::abs(p_left - p_right) < (tolerance < static_cast<T>(CMP_EPSILON) ? static_cast<T>(CMP_EPSILON) : tolerance);
}

} // namespace Math

} // namespace godot
