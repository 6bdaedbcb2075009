#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

struct Quaternion {
	real_t x = 0;
	real_t y = 0;
	real_t z = 0;
	real_t w = 1;

	Quaternion() = default;
	Quaternion(real_t p_x, real_t p_y, real_t p_z, real_t p_w) :
			x(p_x), y(p_y), z(p_z), w(p_w) {}

	Quaternion operator*(const Quaternion &p_right) const {
		return Quaternion(
				w * p_right.x + x * p_right.w + y * p_right.z - z * p_right.y,
				w * p_right.y + y * p_right.w + z * p_right.x - x * p_right.z,
				w * p_right.z + z * p_right.w + x * p_right.y - y * p_right.x,
				w * p_right.w - x * p_right.x - y * p_right.y - z * p_right.z);
	}
	Quaternion operator*(real_t p_scalar) const { return Quaternion(x * p_scalar, y * p_scalar, z * p_scalar, w * p_scalar); }
	Quaternion operator/(real_t p_scalar) const { return Quaternion(x / p_scalar, y / p_scalar, z / p_scalar, w / p_scalar); }

	bool operator==(const Quaternion &p_other) const { return x == p_other.x && y == p_other.y && z == p_other.z && w == p_other.w; }
	bool operator!=(const Quaternion &p_other) const { return !(*this == p_other); }

	real_t dot(const Quaternion &p_with) const { return x * p_with.x + y * p_with.y + z * p_with.z + w * p_with.w; }
	real_t length_squared() const { return dot(*this); }
	real_t length() const { return std::sqrt(length_squared()); }
	Quaternion normalized() const { return *this / length(); }

	// Requires a normalized quaternion.
	Quaternion inverse() const { return Quaternion(-x, -y, -z, w); }

	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z) && Math::is_finite(w); }
	bool is_equal_approx(const Quaternion &p_other) const {
		return Math::is_equal_approx(x, p_other.x) && Math::is_equal_approx(y, p_other.y) && Math::is_equal_approx(z, p_other.z) && Math::is_equal_approx(w, p_other.w);
	}
};

} // namespace godot
