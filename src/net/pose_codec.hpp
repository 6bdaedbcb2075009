#pragma once

#include "cga/motor/pose.hpp"
#include "net/coding/quantization.hpp"
#include "net/coding/body_id.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// One body's pose under its network id.
struct BodyPose {
	uint32_t id = 0;
	cga::Pose<float> pose;
};

/// What went wrong, and at which body (encode) or which body's record (decode).
struct [[nodiscard]] CodecStatus {
	const char *error = nullptr; ///< null on success; a literal
	size_t index = 0;
};

/// Poses as absolute quantised motors, several in one packet; each packet
/// stands alone. Byte-aligned header, then one bit-packed record a body:
///
///   u8       FORMAT_VERSION
///   varint   count of bodies
///   f32      grid step h in metres, little endian
///   u8       bits of a rotor component
///   3 times  zigzag varint: smallest grid index on the axis; u8: bits of the offsets
///   records  1 bit: id is the previous one + 1 (before the first: -1);
///              else 5 bits w, then w bits: zigzag(id - previous - 1)
///            x, y, z offsets
///            2 bits: dropped rotor component; 3 rotor levels (SmallestThree)
///            1 bit: scale is 1; else SCALE_BITS: zigzag(level)
///   zero bits up to a byte
///
/// At the default tolerance in an arena of 40 m this is about 9 bytes a pose.
inline constexpr uint8_t FORMAT_VERSION = 1;

/// Replaces `packet` with the coded bodies. Positions reach the receiver
/// within tolerance.position plus float32 rounding, rotations within
/// tolerance.rotation. On an error `packet` is empty.
CodecStatus encode(const BodyPose *bodies, size_t count, const Tolerance &tolerance, std::vector<uint8_t> &packet);

/// Replaces `bodies` with the packet's content; any bytes are safe input.
/// On an error `bodies` is empty.
CodecStatus decode(const uint8_t *packet, size_t size, std::vector<BodyPose> &bodies);

} // namespace net
