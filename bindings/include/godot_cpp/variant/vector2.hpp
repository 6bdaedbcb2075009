#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

struct Vector2 {
	real_t x = 0;
	real_t y = 0;

	Vector2() = default;
	Vector2(real_t p_x, real_t p_y) :
			x(p_x), y(p_y) {}

	Vector2 operator+(const Vector2 &p_other) const { return Vector2(x + p_other.x, y + p_other.y); }
	Vector2 operator-(const Vector2 &p_other) const { return Vector2(x - p_other.x, y - p_other.y); }
	Vector2 operator*(real_t p_scalar) const { return Vector2(x * p_scalar, y * p_scalar); }

	bool operator==(const Vector2 &p_other) const { return x == p_other.x && y == p_other.y; }
	bool operator!=(const Vector2 &p_other) const { return !(*this == p_other); }

	real_t length() const { return std::sqrt(x * x + y * y); }
	real_t distance_to(const Vector2 &p_to) const { return (p_to - *this).length(); }

	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y); }
};

} // namespace godot
