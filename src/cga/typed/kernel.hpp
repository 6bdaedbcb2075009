#pragma once

#include "cga/typed/null_product.hpp"

// The multiplications in a product of sparse elements, determined at compile time.

namespace cga::typed {

// Bit i stands for the null blade at index i.
using BladeSet = uint32_t;

[[nodiscard]] constexpr bool contains(BladeSet set, int index) {
	return ((set >> index) & 1u) != 0;
}

[[nodiscard]] constexpr int size_of(BladeSet set) {
	return grade_of_bitmap(set);
}

// The position of the coefficient of a blade of the set.
[[nodiscard]] constexpr size_t slot_of(BladeSet set, int index) {
	return size_t(size_of(set & ((BladeSet(1) << index) - 1u)));
}

// The blades that a product of elements of these sets can have.
[[nodiscard]] constexpr BladeSet product_blades(Product product, BladeSet left, BladeSet right) {
	BladeSet blades = 0;
	for (int l = 0; l < BLADE_COUNT; ++l) {
		for (int r = 0; contains(left, l) && r < BLADE_COUNT; ++r) {
			for (int m = 0; contains(right, r) && m < BLADE_COUNT; ++m) {
				blades |= BladeSet(null_sign(product, l, r, m) != 0) << m;
			}
		}
	}
	return blades;
}

// One multiplication: result += sign left right, by slots.
struct Term {
	size_t left = 0;
	size_t right = 0;
	size_t result = 0;
	int sign = 0;
};

// The terms of a product of elements of two sets whose blades are in RESULT.
template <Product PRODUCT, BladeSet LEFT, BladeSet RIGHT, BladeSet RESULT>
struct Kernel {
	template <class Visit>
	static constexpr void for_each_term(Visit visit) {
		for (int m = 0; m < BLADE_COUNT; ++m) {
			for (int l = 0; contains(RESULT, m) && l < BLADE_COUNT; ++l) {
				for (int r = 0; contains(LEFT, l) && r < BLADE_COUNT; ++r) {
					const int sign = contains(RIGHT, r) ? null_sign(PRODUCT, l, r, m) : 0;
					if (sign != 0) {
						visit(Term{ slot_of(LEFT, l), slot_of(RIGHT, r), slot_of(RESULT, m), sign });
					}
				}
			}
		}
	}

	static constexpr size_t count() {
		size_t terms = 0;
		for_each_term([&terms](const Term &) { ++terms; });
		return terms;
	}

	static constexpr size_t COUNT = count();

	static constexpr std::array<Term, COUNT> make_terms() {
		std::array<Term, COUNT> terms{};
		size_t next = 0;
		for_each_term([&terms, &next](const Term &term) { terms[next++] = term; });
		return terms;
	}

	static constexpr std::array<Term, COUNT> TERMS = make_terms();
};

} // namespace cga::typed
