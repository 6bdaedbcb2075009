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

} // namespace cga
