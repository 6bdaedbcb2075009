#include "net/motion/segment_error.inl"

#include "cga/platform/compiler.hpp"
#include "cga/platform/processor.hpp"

namespace net {

float segment_error(const SegmentErrorInput &input, float limit) noexcept {
#if CGA_X86_64
	static const bool HAS_AVX2 = cga::processor_features().avx2;
	if (HAS_AVX2) {
		return segment_error_avx2(input, limit);
	}
#endif
	return max_error(input, limit);
}

} // namespace net
