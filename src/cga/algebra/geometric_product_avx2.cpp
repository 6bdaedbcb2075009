#include "cga/algebra/geometric_product_avx2.hpp"

#include "cga/algebra/product_table.hpp"
#include "cga/platform/compiler.hpp"

#include <utility>

#if CGA_X86_64
#include <immintrin.h>

// The geometric product four coefficients at a time, in the order of bitmaps: with l, m bitmaps, m = 4 c + j,
//   result[4 c + j] = sum over l of sign[l][4 c + j] a[l] b[l ^ (4 c + j)]
// The four coefficients of chunk c read one chunk of b, c ^ (l / 4), permuted by l % 4: 4 permutations of 8 chunks.
// The signs are a bilinear form, so that those of a chunk are the lanes' signs times one sign,
//   sign[l][4 c + j] = sign[l][j] (sign[l][4 c] sign[l][0])
// The lanes' signs are multiplied into a[l] once for all chunks; the chunk's sign selects addition or subtraction at compile time.
//
// Terms are added in pairs, in the order of multiply() and without FMA, so that the results agree bit for bit.

namespace cga {

namespace {

constexpr size_t CHUNKS = size_t(BLADE_COUNT) / 4;

// Chunk c of b in permutation p: lane j is b[4 c + (j ^ p)].
using Permutations = __m256d[4][CHUNKS];

constexpr int lane_sign(size_t left, size_t lane) {
	return SIGN_TABLE<Product::GEOMETRIC>[left][lane];
}

constexpr int chunk_sign(size_t left, size_t chunk) {
	return SIGN_TABLE<Product::GEOMETRIC>[left][4 * chunk] * SIGN_TABLE<Product::GEOMETRIC>[left][0];
}

constexpr bool signs_factor() {
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

template <size_t LEFT>
CGA_ALWAYS_INLINE __m256d signed_left(const double *a) noexcept {
	constexpr double S0 = lane_sign(LEFT, 0), S1 = lane_sign(LEFT, 1), S2 = lane_sign(LEFT, 2), S3 = lane_sign(LEFT, 3);
	constexpr size_t INDEX = BLADE_INDICES[LEFT];
	return _mm256_mul_pd(_mm256_setr_pd(S0, S1, S2, S3), _mm256_set1_pd(a[INDEX]));
}

template <bool ADDS>
CGA_ALWAYS_INLINE __m256d add_or_subtract(__m256d left, __m256d right) noexcept {
	if constexpr (ADDS) {
		return _mm256_add_pd(left, right);
	} else {
		return _mm256_sub_pd(left, right);
	}
}

template <size_t LEFT, size_t CHUNK>
CGA_ALWAYS_INLINE void add_pair(__m256d &sum, __m256d a, __m256d other_a, const Permutations &b) noexcept {
	constexpr size_t OTHER = LEFT ^ (E4_BIT | E5_BIT);
	constexpr int SIGN = chunk_sign(LEFT, CHUNK), OTHER_SIGN = chunk_sign(OTHER, CHUNK);
	const __m256d term = _mm256_mul_pd(a, b[LEFT % 4][CHUNK ^ (LEFT / 4)]);
	const __m256d other_term = _mm256_mul_pd(other_a, b[OTHER % 4][CHUNK ^ (OTHER / 4)]);
	sum = add_or_subtract<(SIGN > 0)>(sum, add_or_subtract < SIGN == OTHER_SIGN > (term, other_term));
}

template <size_t LEFT, size_t... CHUNK>
CGA_ALWAYS_INLINE void add_left(__m256d (&sums)[CHUNKS], const double *a, const Permutations &b, std::index_sequence<CHUNK...>) noexcept {
	const __m256d first = signed_left<LEFT>(a);
	const __m256d other = signed_left<(LEFT ^ (E4_BIT | E5_BIT))>(a);
	(add_pair<LEFT, CHUNK>(sums[CHUNK], first, other, b), ...);
}

// `LEFT` are the bitmaps without e5: one of each pair that differs in e4 and e5.
template <size_t... LEFT>
CGA_ALWAYS_INLINE void add_all(__m256d (&sums)[CHUNKS], const double *a, const Permutations &b, std::index_sequence<LEFT...>) noexcept {
	(add_left<LEFT>(sums, a, b, std::make_index_sequence<CHUNKS>()), ...);
}

template <size_t CHUNK>
CGA_ALWAYS_INLINE void load_chunk(Permutations &permutations, const double *b) noexcept {
	constexpr size_t I0 = BLADE_INDICES[4 * CHUNK], I1 = BLADE_INDICES[4 * CHUNK + 1], I2 = BLADE_INDICES[4 * CHUNK + 2], I3 = BLADE_INDICES[4 * CHUNK + 3];
	const __m256d chunk = _mm256_setr_pd(b[I0], b[I1], b[I2], b[I3]);
	permutations[0][CHUNK] = chunk;
	permutations[1][CHUNK] = _mm256_permute_pd(chunk, 0b0101);
	permutations[2][CHUNK] = _mm256_permute2f128_pd(chunk, chunk, 1);
	permutations[3][CHUNK] = _mm256_permute4x64_pd(chunk, 0b00011011);
}

template <size_t CHUNK>
CGA_ALWAYS_INLINE void store_chunk(double *product, __m256d sum) noexcept {
	constexpr size_t I0 = BLADE_INDICES[4 * CHUNK], I1 = BLADE_INDICES[4 * CHUNK + 1], I2 = BLADE_INDICES[4 * CHUNK + 2], I3 = BLADE_INDICES[4 * CHUNK + 3];
	const __m128d low = _mm256_castpd256_pd128(sum);
	const __m128d high = _mm256_extractf128_pd(sum, 1);
	_mm_storel_pd(product + I0, low);
	_mm_storeh_pd(product + I1, low);
	_mm_storel_pd(product + I2, high);
	_mm_storeh_pd(product + I3, high);
}

template <size_t... CHUNK>
CGA_ALWAYS_INLINE void multiply(const double *a, const double *b, double *product, std::index_sequence<CHUNK...>) noexcept {
	Permutations permutations;
	(load_chunk<CHUNK>(permutations, b), ...);
	__m256d sums[CHUNKS];
	((sums[CHUNK] = _mm256_setzero_pd()), ...);
	add_all(sums, a, permutations, std::make_index_sequence<BLADE_COUNT / 2>());
	(store_chunk<CHUNK>(product, sums[CHUNK]), ...);
}

} // namespace

void geometric_product_avx2(const double *a, const double *b, double *product) noexcept {
	multiply(a, b, product, std::make_index_sequence<CHUNKS>());
}

} // namespace cga

#endif
