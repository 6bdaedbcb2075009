#pragma once

#include <godot_cpp/core/defs.hpp>

namespace godot {

struct Vector3 {
	real_t x = 0;
	real_t y = 0;
	real_t z = 0;

	Vector3() = default;
	Vector3(real_t p_x, real_t p_y, real_t p_z) :
			x(p_x), y(p_y), z(p_z) {}

	const real_t &operator[](int p_axis) const { return p_axis == 0 ? x : (p_axis == 1 ? y : z); }
	real_t &operator[](int p_axis) { return p_axis == 0 ? x : (p_axis == 1 ? y : z); }

	Vector3 operator+(const Vector3 &p_other) const { return Vector3(x + p_other.x, y + p_other.y, z + p_other.z); }
	Vector3 operator-(const Vector3 &p_other) const { return Vector3(x - p_other.x, y - p_other.y, z - p_other.z); }
	Vector3 operator*(real_t p_scalar) const { return Vector3(x * p_scalar, y * p_scalar, z * p_scalar); }

	bool operator==(const Vector3 &p_other) const { return x == p_other.x && y == p_other.y && z == p_other.z; }

	real_t dot(const Vector3 &p_with) const { return x * p_with.x + y * p_with.y + z * p_with.z; }
};

} // namespace godot
