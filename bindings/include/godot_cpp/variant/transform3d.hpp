#pragma once

#include <godot_cpp/variant/basis.hpp>

namespace godot {

// Maps x to basis * x + origin.
struct Transform3D {
	Basis basis;
	Vector3 origin;

	Transform3D() = default;
	Transform3D(const Basis &p_basis, const Vector3 &p_origin = Vector3()) :
			basis(p_basis), origin(p_origin) {}

	Vector3 xform(const Vector3 &p_point) const { return basis.xform(p_point) + origin; }
	Transform3D operator*(const Transform3D &p_right) const { return Transform3D(basis * p_right.basis, xform(p_right.origin)); }

	bool operator==(const Transform3D &p_other) const { return basis == p_other.basis && origin == p_other.origin; }
	bool operator!=(const Transform3D &p_other) const { return !(*this == p_other); }
};

} // namespace godot
