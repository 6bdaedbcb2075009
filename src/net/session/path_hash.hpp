#pragma once

#include <cstdint>
#include <string_view>

// Peers refer to nodes by hashes of their paths, which are the same on all peers.

namespace net {

/// 32-bit FNV-1a hash of a path.
[[nodiscard]] constexpr uint32_t path_hash(std::string_view utf8) {
	uint32_t hash = 2166136261u;
	for (const char byte : utf8) {
		hash = (hash ^ uint8_t(byte)) * 16777619u;
	}
	return hash;
}

/// The id of a body (31 bits), from the path of its node.
[[nodiscard]] constexpr uint32_t path_body(std::string_view utf8) {
	const uint32_t hash = path_hash(utf8);
	return (hash ^ hash >> 31) & 0x7fffffffu;
}

} // namespace net
