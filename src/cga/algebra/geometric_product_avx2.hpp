#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/algebra/product_table.hpp"

#include <utility>

// The geometric product four coefficients at a time, in the order of bitmaps: with l, m bitmaps, m = 4 c + j,
//   result[4 c + j] = sum over l of sign[l][4 c + j] a[l] b[l ^ (4 c + j)]
// The four of a chunk c read one chunk of b, c ^ (l / 4), its entries exchanged as l % 4 says: 4 orders of the 8 chunks.
// Signs are a bilinear form's, so those of a chunk are the chunk's times the lane's,
//   sign[l][4 c + j] = sign[l][j] (sign[l][4 c] sign[l][0])
// of which the first go into a[l], once for all chunks, and the second choose between addition and subtraction when compiling.
//
// Terms are added in pairs and in the order of multiply(), without fused operations: the same bits.

#if defined(__GNUC__) && defined(__x86_64__)
#define CGA_HAS_AVX2_PRODUCT 1

namespace cga::avx2 {

#define CGA_AVX2_INLINE __attribute__((target("avx2"), always_inline)) inline

using FourDoubles = double __attribute__((vector_size(32)));
using FourIndices = long long __attribute__((vector_size(32)));

inline constexpr size_t CHUNKS = size_t(BLADE_COUNT) / 4;

// Chunk c of b in order o: entry j is b[4 c + (j ^ o)].
using Orders = FourDoubles[4][CHUNKS];

[[nodiscard]] constexpr int lane_sign(size_t left, size_t lane) {
	return SIGN_TABLE<Product::GEOMETRIC>[left][lane];
}

[[nodiscard]] constexpr int chunk_sign(size_t left, size_t chunk) {
	return SIGN_TABLE<Product::GEOMETRIC>[left][4 * chunk] * SIGN_TABLE<Product::GEOMETRIC>[left][0];
}

[[nodiscard]] constexpr bool signs_factor() {
	for (size_t left = 0; left < size_t(BLADE_COUNT); ++left) {
		for (size_t result = 0; result < size_t(BLADE_COUNT); ++result) {
			if (SIGN_TABLE<Product::GEOMETRIC>[left][result] != lane_sign(left, result % 4) * chunk_sign(left, result / 4)) {
				return false;
			}
		}
	}
	return true;
}
static_assert(signs_factor());

template <size_t left>
CGA_AVX2_INLINE FourDoubles signed_left(const Multivector &a) noexcept {
	constexpr FourDoubles SIGNS = { double(lane_sign(left, 0)), double(lane_sign(left, 1)), double(lane_sign(left, 2)), double(lane_sign(left, 3)) };
	return SIGNS * a[BLADE_INDICES[left]];
}

template <size_t left, size_t chunk>
CGA_AVX2_INLINE void add_pair(FourDoubles &sum, const FourDoubles &a, const FourDoubles &other_a, const Orders &b) noexcept {
	constexpr size_t OTHER = left ^ (E4_BIT | E5_BIT);
	const FourDoubles term = a * b[left % 4][chunk ^ (left / 4)];
	const FourDoubles other_term = other_a * b[OTHER % 4][chunk ^ (OTHER / 4)];
	const FourDoubles pair = chunk_sign(left, chunk) == chunk_sign(OTHER, chunk) ? term + other_term : term - other_term;
	sum = chunk_sign(left, chunk) > 0 ? sum + pair : sum - pair;
}

template <size_t left, size_t... chunks>
CGA_AVX2_INLINE void add_left(FourDoubles (&sums)[CHUNKS], const Multivector &a, const Orders &b, std::index_sequence<chunks...>) noexcept {
	const FourDoubles one = signed_left<left>(a);
	const FourDoubles other = signed_left<(left ^ (E4_BIT | E5_BIT))>(a);
	(add_pair<left, chunks>(sums[chunks], one, other, b), ...);
}

template <size_t... lefts>
CGA_AVX2_INLINE void add_lefts(FourDoubles (&sums)[CHUNKS], const Multivector &a, const Orders &b, std::index_sequence<lefts...>) noexcept {
	(add_left<lefts>(sums, a, b, std::make_index_sequence<CHUNKS>()), ...);
}

template <size_t... chunks>
CGA_AVX2_INLINE void load_orders(Orders &orders, const Multivector &b, std::index_sequence<chunks...>) noexcept {
	((orders[0][chunks] = FourDoubles{ b[BLADE_INDICES[4 * chunks]], b[BLADE_INDICES[4 * chunks + 1]], b[BLADE_INDICES[4 * chunks + 2]], b[BLADE_INDICES[4 * chunks + 3]] }), ...);
	((orders[1][chunks] = __builtin_shuffle(orders[0][chunks], FourIndices{ 1, 0, 3, 2 })), ...);
	((orders[2][chunks] = __builtin_shuffle(orders[0][chunks], FourIndices{ 2, 3, 0, 1 })), ...);
	((orders[3][chunks] = __builtin_shuffle(orders[0][chunks], FourIndices{ 3, 2, 1, 0 })), ...);
}

__attribute__((target("avx2"))) inline Multivector geometric_product(const Multivector &a, const Multivector &b) noexcept {
	Orders orders;
	load_orders(orders, b, std::make_index_sequence<CHUNKS>());
	FourDoubles sums[CHUNKS] = {};
	add_lefts(sums, a, orders, std::make_index_sequence<BLADE_COUNT / 2>());
	Multivector product;
	for (size_t bitmap = 0; bitmap < size_t(BLADE_COUNT); ++bitmap) {
		product[BLADE_INDICES[bitmap]] = sums[bitmap / 4][bitmap % 4];
	}
	return product;
}

#undef CGA_AVX2_INLINE

} // namespace cga::avx2

#endif
