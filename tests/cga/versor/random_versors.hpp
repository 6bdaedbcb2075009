#pragma once

#include "../random_poses.hpp"
#include "cga/algebra/null_basis.hpp"

// Random versors of all kinds in Cl(4,1).

namespace cga_test {

// A vector whose square is not near zero: a plane or a real or imaginary sphere to reflect in.
inline cga::Multivector random_mirror(Random &random) {
	for (;;) {
		const cga::Multivector vector = random.multivector().grade(1);
		if (std::abs(vector.norm_squared()) > 0.1 * vector.max_abs() * vector.max_abs()) {
			return vector * (1.0 / vector.norm());
		}
	}
}

inline cga::Multivector random_product(Random &random, int factors) {
	cga::Multivector product = cga::Multivector::scalar(1.0);
	for (int factor = 0; factor < factors; ++factor) {
		product = product.geometric_product(random_mirror(random));
	}
	return product;
}

// An even versor with M M~ = 1.
inline cga::Multivector random_even_versor(Random &random) {
	for (;;) {
		const cga::Multivector product = random_product(random, random.uniform(0.0, 1.0) < 0.5 ? 2 : 4);
		if (product.norm_squared() > 0.0) {
			return product;
		}
	}
}

// Inversion, translation, inversion: 1 + t e_o.
inline cga::Multivector transversion(const Vector3D &t) {
	return cga::Multivector::scalar(1.0) + cga::euclidean(t).geometric_product(cga::e_origin());
}

} // namespace cga_test
