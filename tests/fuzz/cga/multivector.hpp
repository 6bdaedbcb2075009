#pragma once

#include "../input.hpp"

#include "cga/algebra/algebra_error.hpp"
#include "cga/object/construct.hpp"
#include "cga/object/incidence.hpp"

namespace fuzz {

inline cga::Vector3<double> vector_from(Input &input) {
	return { input.number(), input.number(), input.number() };
}

/// A multivector: any coefficients, an object, or a product of two.
inline cga::Multivector multivector_from(Input &input, int depth = 2) {
	const uint8_t kind = input.byte() % 24;
	cga::MultivectorResult made = cga::Multivector();
	switch (kind) {
		case 0: {
			cga::Multivector any;
			for (int i = 0; i < 32; ++i) {
				any[i] = input.number();
			}
			return any;
		}
		case 1:
		case 2: {
			cga::Multivector sparse;
			for (size_t terms = input.byte() % 8; terms > 0; --terms) {
				sparse[int(input.byte() % 32)] = input.number();
			}
			return sparse;
		}
		case 3:
			made = cga::point_pair(vector_from(input), vector_from(input));
			break;
		case 4:
			made = cga::line(vector_from(input), vector_from(input));
			break;
		case 5:
			made = cga::circle(vector_from(input), vector_from(input), input.number());
			break;
		case 6:
			made = cga::plane(vector_from(input), input.number());
			break;
		case 7:
			made = cga::sphere(vector_from(input), input.number());
			break;
		case 8:
			made = cga::imaginary_circle(vector_from(input), vector_from(input), input.number());
			break;
		case 9:
			made = cga::tangent_along(vector_from(input), vector_from(input));
			break;
		case 10:
			made = cga::direction_across(vector_from(input));
			break;
		case 11:
			made = cga::circle_through(vector_from(input), vector_from(input), vector_from(input));
			break;
		case 12:
			made = cga::sphere_through(vector_from(input), vector_from(input), vector_from(input), vector_from(input));
			break;
		case 13:
			made = cga::flat_point(vector_from(input));
			break;
		case 14:
			return cga::Multivector::scalar(input.number());
		default: {
			if (depth == 0) {
				return cga::Multivector::basis_blade(int(input.byte() % 32), input.number());
			}
			const cga::Multivector left = multivector_from(input, depth - 1);
			const cga::Multivector right = multivector_from(input, depth - 1);
			switch (kind) {
				case 15:
				case 16:
					return left.geometric_product(right);
				case 17:
					return left.outer_product(right);
				case 18:
					return left.inner_product(right);
				case 19:
					return left.regressive_product(right);
				case 20:
					return left.dual() + right;
				case 21:
					made = cga::meet(left, right);
					break;
				case 22:
					made = cga::join(left, right);
					break;
				default:
					made = cga::reflect_in(left, right);
			}
		}
	}
	return made ? *made : cga::Multivector();
}

} // namespace fuzz
