#pragma once

#include <godot_cpp/core/defs.hpp>

namespace godot {

struct Vector2 {
	real_t x = 0;
	real_t y = 0;

	Vector2() = default;
	Vector2(real_t p_x, real_t p_y) :
			x(p_x), y(p_y) {}

	Vector2 operator+(const Vector2 &p_other) const { return Vector2(x + p_other.x, y + p_other.y); }

	bool operator==(const Vector2 &p_other) const { return x == p_other.x && y == p_other.y; }
	bool operator!=(const Vector2 &p_other) const { return !(*this == p_other); }
};

} // namespace godot
