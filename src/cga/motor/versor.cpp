#include "cga/motor/versor.hpp"

#include <cmath>

namespace cga {

Multivector point(const Vector3<double> &position) {
	return euclidean(position) + e_infinity() * (0.5 * glm::dot(position, position)) + e_origin();
}

std::optional<Vector3<double>> position_of(const Multivector &point) {
	const double weight = -e_infinity().scalar_product(point);
	const Vector3<double> position = Vector3<double>(point[E1], point[E2], point[E3]) / weight;
	if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z)) {
		return std::nullopt;
	}
	return position;
}

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
