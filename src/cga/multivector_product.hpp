#pragma once

#include "cga/multivector.hpp"
#include "cga/product_table.hpp"

namespace cga {

// A product of two multivectors from its sign table:
//   result[m] = sum over l of sign[l][m] left[l] right[l ^ m]     (l, m bitmaps)
// The xor splits into lanes of four and blocks of four: with the right side copied in the four orders of lanes,
// both factors are read in whole vectors. Coefficients of the left that are zero cost nothing, which is most of
// them for points, rotors and motors.
template <Product product>
[[nodiscard]] Multivector multiply(const Multivector &left, const Multivector &right) {
	constexpr const SignTable &SIGNS = SIGN_TABLE<product>;
	constexpr unsigned LANES = 4;
	constexpr unsigned PART = 16; // sums that fit in registers

	alignas(64) double lanes_swapped[LANES][BLADE_COUNT];
	for (unsigned order = 0; order < LANES; ++order) {
		for (unsigned bitmap = 0; bitmap < BLADE_COUNT; ++bitmap) {
			lanes_swapped[order][bitmap] = right[BLADE_INDICES[bitmap ^ order]];
		}
	}

	Multivector result;
	for (unsigned part = 0; part < BLADE_COUNT; part += PART) {
		double sums[PART] = {};
		for (unsigned bitmap = 0; bitmap < BLADE_COUNT; ++bitmap) {
			const double coefficient = left[BLADE_INDICES[bitmap]];
			if (coefficient == 0.0) {
				continue;
			}
			const double *signs = SIGNS[bitmap].data() + part;
			const double *factors = lanes_swapped[bitmap % LANES];
			const unsigned swapped_blocks = bitmap - bitmap % LANES;
			for (unsigned block = 0; block < PART; block += LANES) {
				const double *block_signs = signs + block;
				const double *block_factors = factors + ((part + block) ^ swapped_blocks);
				for (unsigned lane = 0; lane < LANES; ++lane) {
					sums[block + lane] += coefficient * block_signs[lane] * block_factors[lane];
				}
			}
		}
		for (unsigned bitmap = 0; bitmap < PART; ++bitmap) {
			result[BLADE_INDICES[part + bitmap]] = sums[bitmap];
		}
	}
	return result;
}

} // namespace cga
