#include "cga/algebra/null_basis.hpp"

namespace cga {

Multivector e_infinity() {
	return Multivector::basis_blade(E4) + Multivector::basis_blade(E5);
}

Multivector e_origin() {
	return (Multivector::basis_blade(E5) - Multivector::basis_blade(E4)) * 0.5;
}

Multivector euclidean(const Vector3<double> &vector) {
	Multivector result;
	result[E1] = vector.x;
	result[E2] = vector.y;
	result[E3] = vector.z;
	return result;
}

Multivector point(const Vector3<double> &position) {
	return euclidean(position) + e_infinity() * (0.5 * glm::dot(position, position)) + e_origin();
}

std::optional<Vector3<double>> position_of(const Multivector &point) {
	const double weight = -e_infinity().scalar_product(point);
	const Vector3<double> position = Vector3<double>(point[E1], point[E2], point[E3]) / weight;
	return is_finite(position) ? std::optional(position) : std::nullopt;
}

} // namespace cga
