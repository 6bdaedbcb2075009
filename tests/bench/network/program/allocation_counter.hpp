#pragma once

#include <cstdint>

namespace bench {

/// How often this program has asked for memory with operator new.
[[nodiscard]] uint64_t allocation_count();

} // namespace bench
