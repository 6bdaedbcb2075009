#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

// A 3x3 matrix stored by rows. Its columns are the images of the axes.
struct Basis {
	Vector3 rows[3] = { Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1) };

	Basis() = default;
	Basis(real_t p_xx, real_t p_xy, real_t p_xz, real_t p_yx, real_t p_yy, real_t p_yz, real_t p_zx, real_t p_zy, real_t p_zz) :
			rows{ Vector3(p_xx, p_xy, p_xz), Vector3(p_yx, p_yy, p_yz), Vector3(p_zx, p_zy, p_zz) } {}
	Basis(const Vector3 &p_x_axis, const Vector3 &p_y_axis, const Vector3 &p_z_axis) :
			Basis(p_x_axis.x, p_y_axis.x, p_z_axis.x, p_x_axis.y, p_y_axis.y, p_z_axis.y, p_x_axis.z, p_y_axis.z, p_z_axis.z) {}

	Vector3 get_column(int p_index) const { return Vector3(rows[0][p_index], rows[1][p_index], rows[2][p_index]); }

	Vector3 xform(const Vector3 &p_vector) const { return Vector3(rows[0].dot(p_vector), rows[1].dot(p_vector), rows[2].dot(p_vector)); }
	Basis operator*(const Basis &p_right) const { return Basis(xform(p_right.get_column(0)), xform(p_right.get_column(1)), xform(p_right.get_column(2))); }

	bool operator==(const Basis &p_other) const { return rows[0] == p_other.rows[0] && rows[1] == p_other.rows[1] && rows[2] == p_other.rows[2]; }
};

} // namespace godot
