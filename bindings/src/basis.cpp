#include <godot_cpp/variant/basis.hpp>

namespace godot {

Basis::Basis(const Quaternion &p_quaternion) {
	// The columns of q e q*, divided by |q|^2.
	const Quaternion &q = p_quaternion;
	const real_t s = 2 / q.length_squared();
	const real_t xx = q.x * q.x * s, yy = q.y * q.y * s, zz = q.z * q.z * s;
	const real_t xy = q.x * q.y * s, xz = q.x * q.z * s, yz = q.y * q.z * s;
	const real_t wx = q.w * q.x * s, wy = q.w * q.y * s, wz = q.w * q.z * s;
	*this = Basis(
			1 - (yy + zz), xy - wz, xz + wy,
			xy + wz, 1 - (xx + zz), yz - wx,
			xz - wy, yz + wx, 1 - (xx + yy));
}

Basis Basis::operator*(const Basis &p_right) const {
	return Basis(xform(p_right.get_column(0)), xform(p_right.get_column(1)), xform(p_right.get_column(2)));
}

Quaternion Basis::get_quaternion() const {
	// Compute the largest component first. It is at least 1/2, so no division is by a small number.
	const real_t trace = rows[0].x + rows[1].y + rows[2].z;
	if (trace > 0) {
		const real_t root = std::sqrt(trace + 1);
		const real_t over = real_t(0.5) / root;
		return Quaternion((rows[2].y - rows[1].z) * over, (rows[0].z - rows[2].x) * over, (rows[1].x - rows[0].y) * over, root * real_t(0.5));
	}
	const int i = rows[0].x < rows[1].y ? (rows[1].y < rows[2].z ? 2 : 1) : (rows[0].x < rows[2].z ? 2 : 0);
	const int j = (i + 1) % 3;
	const int k = (i + 2) % 3;
	const real_t root = std::sqrt(rows[i][i] - rows[j][j] - rows[k][k] + 1);
	const real_t over = real_t(0.5) / root;
	Vector3 imaginary;
	imaginary[i] = root * real_t(0.5);
	imaginary[j] = (rows[j][i] + rows[i][j]) * over;
	imaginary[k] = (rows[k][i] + rows[i][k]) * over;
	return Quaternion(imaginary.x, imaginary.y, imaginary.z, (rows[k][j] - rows[j][k]) * over);
}

} // namespace godot
