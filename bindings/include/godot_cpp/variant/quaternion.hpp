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

	// The axis must have length 1, the angle is in radians.
	Quaternion(const Vector3 &p_axis, real_t p_angle) {
		const real_t sine = std::sin(p_angle * real_t(0.5));
		x = p_axis.x * sine;
		y = p_axis.y * sine;
		z = p_axis.z * sine;
		w = std::cos(p_angle * real_t(0.5));
	}

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
	bool is_normalized() const { return std::abs(length_squared() - 1) < real_t(UNIT_EPSILON); }

	// Of a quaternion of length 1.
	Quaternion inverse() const { return Quaternion(-x, -y, -z, w); }

	// The vector rotated by this quaternion of length 1.
	Vector3 xform(const Vector3 &p_vector) const {
		const Vector3 axis(x, y, z);
		const Vector3 twice = axis.cross(p_vector) * 2;
		return p_vector + twice * w + axis.cross(twice);
	}

	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z) && Math::is_finite(w); }
	bool is_equal_approx(const Quaternion &p_other) const {
		return Math::is_equal_approx(x, p_other.x) && Math::is_equal_approx(y, p_other.y) && Math::is_equal_approx(z, p_other.z) && Math::is_equal_approx(w, p_other.w);
	}
};

} // namespace godot
