#pragma once

#include <cstddef>
#include <cstdint>

// Programs that link allocation_counter.cpp replace the global operators new and delete. Not thread-safe.

namespace harness {

/// Calls of operator new since the program started.
[[nodiscard]] uint64_t allocation_count();
/// Allocated bytes in use, with the rounding of malloc.
[[nodiscard]] size_t live_bytes();

} // namespace harness
