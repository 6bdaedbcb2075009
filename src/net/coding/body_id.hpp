#pragma once

#include <cstdint>

namespace net {

/// Body ids are less than this limit, so that they fit in a signed 32-bit integer.
inline constexpr uint32_t ID_LIMIT = 0x80000000u;

} // namespace net
