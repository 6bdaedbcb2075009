#pragma once

#include <cstddef>

#ifdef ASAN_ENABLED
#include <sanitizer/allocator_interface.h>
#else
#include <malloc.h>
#endif

namespace fuzz {

/// Allocated bytes in use. (harness::live_bytes() replaces operator new, which does not go together with libFuzzer's own code.)
[[nodiscard]] inline size_t live_bytes() {
#ifdef ASAN_ENABLED
	return __sanitizer_get_current_allocated_bytes();
#else
	return mallinfo2().uordblks;
#endif
}

} // namespace fuzz
