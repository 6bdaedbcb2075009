#pragma once

#include "../random_poses.hpp"
#include "cga/typed/sparse.hpp"

// Random typed elements, and their difference from multivectors.

namespace cga_test {

template <class Element>
Element random_element(Random &random) {
	Element element;
	for (auto &coefficient : element.coefficients) {
		coefficient = random.normal();
	}
	return element;
}

template <cga::typed::BladeSet BLADES>
double difference(const cga::typed::Sparse<BLADES> &element, const cga::Multivector &wanted) {
	return (element.to_multivector() - wanted).max_abs() / std::max(1.0, wanted.max_abs());
}

} // namespace cga_test
