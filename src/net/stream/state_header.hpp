#pragma once

#include "net/stream_settings.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// What a state begins with.
struct StateHeader {
	static constexpr size_t BYTES = 30;

	StreamSettings settings; ///< send_rate is not told
	uint32_t tick = 0; ///< the media time of the state
	float window = 0.0f; ///< seconds: the usual length of a window
};

void put_state_header(std::vector<uint8_t> &bytes, const StateHeader &header);
/// Null, or what is wrong (a literal).
const char *read_state_header(const uint8_t *bytes, size_t size, StateHeader &header);

} // namespace net
