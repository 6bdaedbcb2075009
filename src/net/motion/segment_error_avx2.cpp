#include "cga/platform/compiler.hpp"

#if CGA_X86_64

#include "net/motion/segment_error.inl"

namespace net {

float segment_error_avx2(const SegmentErrorInput &input, float limit) noexcept {
	return max_error(input, limit);
}

} // namespace net

#endif
