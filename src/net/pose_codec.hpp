#pragma once

#include "cga/motor/pose.hpp"
#include "cga/result.hpp"
#include "net/coding/body_id.hpp"
#include "net/coding/quantization.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// A body's pose and network id.
struct BodyPose {
	uint32_t id = 0;
	cga::Pose<float> pose;
};

/// Why encode or decode failed.
enum class CodecFault : uint8_t {
	// encode(): the input.
	ID_OUT_OF_RANGE,
	POSE_NOT_FINITE,
	POSITION_TOO_FAR,
	ROTATION_NOT_UNIT,
	SCALE_OUT_OF_RANGE,
	POSITION_TOLERANCE_OUT_OF_RANGE,
	ROTATION_TOLERANCE_OUT_OF_RANGE,
	// decode(): the packet.
	OTHER_FORMAT_VERSION,
	HEADER_POSITION_OUT_OF_RANGE,
	HEADER_TRUNCATED,
	GRID_STEP_NOT_POSITIVE,
	ROTOR_SIZE_OUT_OF_RANGE,
	TOO_SHORT_FOR_COUNT,
	BODY_POSITION_NOT_FINITE,
	TRUNCATED,
	BODY_ID_OUT_OF_RANGE,
	BODY_ROTOR_NOT_UNIT,
	BODY_SCALE_OUT_OF_RANGE,
	TRAILING_BYTES,
};

/// Describes the fault as a clause without a period.
[[nodiscard]] const char *describe(CodecFault fault);

struct CodecError {
	CodecFault fault;
	size_t index; ///< of the faulty body or record; 0 if the fault is elsewhere
};

using CodecResult = cga::Result<void, CodecError>;

/// Version of the packet format. A packet holds the absolute, quantized poses of several bodies and can be decoded on its
/// own. It consists of a byte-aligned header and one bit-packed record per body:
///
///   u8       FORMAT_VERSION
///   varint   count of bodies
///   f32      grid step h in meters, little endian
///   u8       bits of a rotor component
///   3 times  zigzag varint: minimum grid index on the axis; u8: bits of the offsets
///   records  1 bit: id is the previous one + 1 (before the first: -1);
///              else 5 bits w, then w bits: zigzag(id - previous - 1)
///            x, y, z offsets
///            2 bits: dropped rotor component; 3 rotor levels (SmallestThree)
///            1 bit: scale is 1; else SCALE_BITS: zigzag(level)
///   zero bits up to a byte
///
/// At the default tolerance, in an arena of 40 m, a pose takes about 9 bytes.
inline constexpr uint8_t FORMAT_VERSION = 1;

/// Replaces `packet` with the encoded bodies. The error of positions is at most tolerance.position plus float32 rounding, that
/// of rotations at most tolerance.rotation. On failure `packet` is empty.
CodecResult encode(const BodyPose *bodies, size_t count, const Tolerance &tolerance, std::vector<uint8_t> &packet);

/// Replaces `bodies` with the packet's content. Any bytes are safe input. On failure `bodies` is empty.
CodecResult decode(const uint8_t *packet, size_t size, std::vector<BodyPose> &bodies);

} // namespace net
