#include "load_and_store_avx2.hpp"

#include "cga/platform/compiler.hpp"

#if CGA_X86_64
#include <immintrin.h>

namespace kernels_bench {

void load_and_store(const cga::PoseBlock *blocks, size_t block_count, float *rows) noexcept {
	constexpr size_t WRITTEN = cga::ROW_FLOATS;
	constexpr size_t READ = 20;
	__m256 unused = _mm256_setzero_ps();
	for (size_t block = 0; block < block_count; ++block) {
		const float *source = blocks[block].from_rotation[0];
		float *destination = rows + block * WRITTEN * 8;
		for (size_t row = 0; row < WRITTEN; ++row) {
			const __m256 value = _mm256_load_ps(source + 8 * row);
			_mm_storeu_ps(destination + 8 * row, _mm256_castps256_ps128(value));
			_mm_storeu_ps(destination + 8 * row + 4, _mm256_extractf128_ps(value, 1));
		}
		for (size_t row = WRITTEN; row < READ; ++row) {
			unused = _mm256_xor_ps(unused, _mm256_load_ps(source + 8 * row)); // keeps the compiler from dropping the load
		}
	}
	volatile float sink = _mm256_cvtss_f32(unused);
	(void)sink;
}

} // namespace kernels_bench

#endif
