#include "cga/motor/motor_factors.hpp"

#include <cmath>

namespace cga {

Multivector translator(const Vector3<double> &offset) {
	return Multivector::scalar(1.0) - euclidean(offset).geometric_product(e_infinity()) * 0.5;
}

Multivector rotor(const Quaternion<double> &rotation) {
	Multivector result = Multivector::scalar(rotation.w);
	result[E12] = -rotation.z;
	result[E13] = rotation.y;
	result[E23] = -rotation.x;
	return result;
}

// cosh(g/2) and sinh(g/2) of g = ln s are (r + 1/r)/2 and (r - 1/r)/2 of r = sqrt(s).
Multivector dilator(double scale) {
	const double root = std::sqrt(scale);
	const Multivector minkowski_plane = e_infinity().outer_product(e_origin());
	return Multivector::scalar(0.5 * (root + 1.0 / root)) - minkowski_plane * (0.5 * (root - 1.0 / root));
}

} // namespace cga
