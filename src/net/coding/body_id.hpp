#pragma once

#include <cstdint>

namespace net {

/// Ids of bodies are below this limit, so that they fit a signed 32-bit integer.
inline constexpr uint32_t ID_LIMIT = 0x80000000u;

} // namespace net
