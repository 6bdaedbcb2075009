#pragma once

#include <cstddef>

namespace net_test {

/// How often this program has asked for memory with operator new, and how many bytes of that it holds.
size_t allocation_count();
size_t live_bytes();

} // namespace net_test
