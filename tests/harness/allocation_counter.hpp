#pragma once

#include <cstddef>
#include <cstdint>

// Programs that link allocation_counter.cpp replace the global operators new and delete. For one thread.

namespace harness {

/// Calls of operator new since the program started.
[[nodiscard]] uint64_t allocation_count();
/// Bytes in use of what operator new allocated, as malloc rounds them.
[[nodiscard]] size_t live_bytes();

} // namespace harness
