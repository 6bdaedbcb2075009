#pragma once

#include <algorithm>
#include <cstddef>

// Work of decoding, in units of about 16 ns.

namespace net {

/// A window, whatever it contains.
inline constexpr size_t WINDOW_WORK = 64;
/// A body whose motion is decoded, even if it rests.
inline constexpr size_t BODY_WORK = 1;
/// A segment of a body's motion, with its place in the body's track.
inline constexpr size_t SEGMENT_WORK = 16;
/// A body in a snapshot, or one that is added, jumps or is removed.
inline constexpr size_t NEW_BODY_WORK = 64;
/// A snapshot, whatever it contains.
inline constexpr size_t SNAPSHOT_WORK = 1024;
/// Number of bytes that cost a unit.
inline constexpr size_t BYTES_PER_WORK = 16;

/// The maximum work of a window after which there are `bodies` bodies: several times that of any scene. It bounds the memory for
/// its segments, too.
[[nodiscard]] inline size_t max_window_work(size_t bodies) {
	return (size_t(1) << 20) + std::min(256 * bodies, size_t(1) << 23);
}

} // namespace net
