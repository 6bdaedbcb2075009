#pragma once

#include <godot_cpp/core/math.hpp>

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
	Vector3 operator*(const Vector3 &p_other) const { return Vector3(x * p_other.x, y * p_other.y, z * p_other.z); }
	Vector3 operator*(real_t p_scalar) const { return Vector3(x * p_scalar, y * p_scalar, z * p_scalar); }
	Vector3 operator/(real_t p_scalar) const { return Vector3(x / p_scalar, y / p_scalar, z / p_scalar); }
	Vector3 operator-() const { return Vector3(-x, -y, -z); }

	Vector3 &operator+=(const Vector3 &p_other) { return *this = *this + p_other; }
	Vector3 &operator-=(const Vector3 &p_other) { return *this = *this - p_other; }
	Vector3 &operator*=(real_t p_scalar) { return *this = *this * p_scalar; }
	Vector3 &operator/=(real_t p_scalar) { return *this = *this / p_scalar; }

	bool operator==(const Vector3 &p_other) const { return x == p_other.x && y == p_other.y && z == p_other.z; }
	bool operator!=(const Vector3 &p_other) const { return !(*this == p_other); }

	real_t dot(const Vector3 &p_with) const { return x * p_with.x + y * p_with.y + z * p_with.z; }
	Vector3 cross(const Vector3 &p_with) const {
		return Vector3(y * p_with.z - z * p_with.y, z * p_with.x - x * p_with.z, x * p_with.y - y * p_with.x);
	}

	real_t length_squared() const { return dot(*this); }
	real_t length() const { return std::sqrt(length_squared()); }
	real_t distance_to(const Vector3 &p_to) const { return (p_to - *this).length(); }

	// Zero stays zero.
	Vector3 normalized() const {
		const real_t squared = length_squared();
		return squared == 0 ? Vector3() : *this / std::sqrt(squared);
	}

	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z); }
	bool is_equal_approx(const Vector3 &p_other) const {
		return Math::is_equal_approx(x, p_other.x) && Math::is_equal_approx(y, p_other.y) && Math::is_equal_approx(z, p_other.z);
	}
};

inline Vector3 operator*(real_t p_scalar, const Vector3 &p_vector) {
	return p_vector * p_scalar;
}

} // namespace godot
