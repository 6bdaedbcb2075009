#include "net/pose_codec.hpp"

#include "net/coding/bit_stream.hpp"
#include "net/stream/setting_range.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace net {

namespace {

constexpr int ID_WIDTH_BITS = 5;
/// Grid indices stay below 2^48, so that offsets fit one BitWriter field.
constexpr double MAX_GRID_INDEX = 281474976710656.0;
constexpr int MAX_OFFSET_BITS = 49;

/// The bounding box of the grid indices of a packet's bodies.
struct Grid {
	float step = 0;
	int rotor_bits = 0;
	int64_t origin[3] = { 0, 0, 0 };
	int bits[3] = { 0, 0, 0 };
};

int64_t grid_index(float coordinate, float step) {
	return std::llround(double(coordinate) / double(step));
}

bool is_finite(const cga::Pose<float> &pose) {
	return std::isfinite(pose.translation.x) && std::isfinite(pose.translation.y) && std::isfinite(pose.translation.z) &&
			std::isfinite(pose.rotation.w) && std::isfinite(pose.rotation.x) && std::isfinite(pose.rotation.y) && std::isfinite(pose.rotation.z);
}

std::optional<CodecFault> find_fault(const BodyPose &body, float step) {
	if (body.id >= ID_LIMIT) {
		return CodecFault::ID_OUT_OF_RANGE;
	}
	if (!is_finite(body.pose)) {
		return CodecFault::POSE_NOT_FINITE;
	}
	for (int axis = 0; axis < 3; ++axis) {
		if (std::abs(double(body.pose.translation[axis]) / double(step)) >= MAX_GRID_INDEX) {
			return CodecFault::POSITION_TOO_FAR;
		}
	}
	const float norm = glm::length(body.pose.rotation);
	if (!(norm > 0.5f && norm < 2.0f)) {
		return CodecFault::ROTATION_NOT_UNIT;
	}
	if (!quantize_scale(body.pose.scale)) {
		return CodecFault::SCALE_OUT_OF_RANGE;
	}
	return std::nullopt;
}

Grid enclosing_grid(const BodyPose *bodies, size_t count, const Tolerance &tolerance) {
	Grid grid;
	grid.step = position_step(tolerance.position);
	grid.rotor_bits = rotor_bits(tolerance.rotation);
	for (int axis = 0; axis < 3 && count > 0; ++axis) {
		const auto [lowest, highest] = std::minmax_element(bodies, bodies + count, [axis](const BodyPose &a, const BodyPose &b) { return a.pose.translation[axis] < b.pose.translation[axis]; });
		grid.origin[axis] = grid_index(lowest->pose.translation[axis], grid.step);
		grid.bits[axis] = bit_width(uint64_t(grid_index(highest->pose.translation[axis], grid.step) - grid.origin[axis]));
	}
	return grid;
}

void write_header(BitWriter &writer, const Grid &grid, size_t count) {
	uint32_t step_bits = 0;
	std::memcpy(&step_bits, &grid.step, sizeof(step_bits));
	writer.write(FORMAT_VERSION, 8);
	writer.write_varint(count);
	writer.write(step_bits, 32);
	writer.write(uint64_t(grid.rotor_bits), 8);
	for (int axis = 0; axis < 3; ++axis) {
		writer.write_varint(zigzag(grid.origin[axis]));
		writer.write(uint64_t(grid.bits[axis]), 8);
	}
}

void write_body(BitWriter &writer, const Grid &grid, const BodyPose &body, int64_t previous_id) {
	const int64_t gap = int64_t(body.id) - previous_id - 1;
	writer.write(gap == 0, 1);
	if (gap != 0) {
		const uint64_t code = zigzag(gap);
		const int width = bit_width(code);
		// Widths 1 to 32 as 0 to 31; the gap is not zero here.
		writer.write(uint64_t(width - 1), ID_WIDTH_BITS);
		writer.write(code, width);
	}
	for (int axis = 0; axis < 3; ++axis) {
		writer.write(uint64_t(grid_index(body.pose.translation[axis], grid.step) - grid.origin[axis]), grid.bits[axis]);
	}
	const SmallestThree rotor = quantize_rotor(glm::normalize(body.pose.rotation), grid.rotor_bits);
	writer.write(rotor.dropped, 2);
	for (const uint32_t level : rotor.level) {
		writer.write(level, grid.rotor_bits);
	}
	const int32_t scale_level = *quantize_scale(body.pose.scale);
	writer.write(scale_level == 0, 1);
	if (scale_level != 0) {
		writer.write(zigzag(scale_level), SCALE_BITS);
	}
}

std::optional<CodecFault> read_header(BitReader &reader, Grid &grid, size_t &count) {
	if (reader.read(8) != FORMAT_VERSION && !reader.failed()) {
		return CodecFault::OTHER_FORMAT_VERSION;
	}
	count = reader.read_varint();
	const uint32_t step_bits = uint32_t(reader.read(32));
	std::memcpy(&grid.step, &step_bits, sizeof(grid.step));
	grid.rotor_bits = int(reader.read(8));
	size_t record_bits = 1 + 2 + 3 * size_t(grid.rotor_bits) + 1;
	for (int axis = 0; axis < 3; ++axis) {
		grid.origin[axis] = unzigzag(reader.read_varint());
		grid.bits[axis] = int(reader.read(8));
		if (std::abs(double(grid.origin[axis])) > MAX_GRID_INDEX || grid.bits[axis] > MAX_OFFSET_BITS) {
			return CodecFault::HEADER_POSITION_OUT_OF_RANGE;
		}
		record_bits += size_t(grid.bits[axis]);
	}
	if (reader.failed()) {
		return CodecFault::HEADER_TRUNCATED;
	}
	if (!std::isfinite(grid.step) || !(grid.step > 0)) {
		return CodecFault::GRID_STEP_NOT_POSITIVE;
	}
	if (grid.rotor_bits < MIN_ROTOR_BITS || grid.rotor_bits > MAX_ROTOR_BITS) {
		return CodecFault::ROTOR_SIZE_OUT_OF_RANGE;
	}
	// This also bounds the memory that a forged count can make the receiver allocate.
	if (count > reader.bits_left() / record_bits) {
		return CodecFault::TOO_SHORT_FOR_COUNT;
	}
	return std::nullopt;
}

std::optional<CodecFault> read_body(BitReader &reader, const Grid &grid, int64_t previous_id, BodyPose &body) {
	int64_t id = previous_id + 1;
	if (reader.read(1) == 0) {
		const int width = int(reader.read(ID_WIDTH_BITS)) + 1;
		id += unzigzag(reader.read(width));
	}
	for (int axis = 0; axis < 3; ++axis) {
		const int64_t index = grid.origin[axis] + int64_t(reader.read(grid.bits[axis]));
		body.pose.translation[axis] = float(double(index) * double(grid.step));
		if (!std::isfinite(body.pose.translation[axis])) {
			return CodecFault::BODY_POSITION_NOT_FINITE;
		}
	}
	SmallestThree rotor;
	rotor.dropped = uint32_t(reader.read(2));
	for (uint32_t &level : rotor.level) {
		level = uint32_t(reader.read(grid.rotor_bits));
	}
	int64_t scale_level = 0;
	if (reader.read(1) == 0) {
		scale_level = unzigzag(reader.read(SCALE_BITS));
	}
	if (reader.failed()) {
		return CodecFault::TRUNCATED;
	}
	if (id < 0 || id >= int64_t(ID_LIMIT)) {
		return CodecFault::BODY_ID_OUT_OF_RANGE;
	}
	const std::optional<glm::quat> rotation = dequantize_rotor(rotor, grid.rotor_bits);
	if (!rotation) {
		return CodecFault::BODY_ROTOR_NOT_UNIT;
	}
	if (scale_level > MAX_SCALE_LEVEL || scale_level < -MAX_SCALE_LEVEL) {
		return CodecFault::BODY_SCALE_OUT_OF_RANGE;
	}
	body.id = uint32_t(id);
	body.pose.rotation = *rotation;
	body.pose.scale = dequantize_scale(int32_t(scale_level));
	return std::nullopt;
}

} // namespace

const char *describe(CodecFault fault) {
	// In the order of the enumerators.
	static constexpr const char *DESCRIPTIONS[] = {
		"the id is negative or above 2147483647",
		"the pose is not finite",
		"the position is too far from the origin for this position_tolerance",
		"the rotation is not a unit quaternion",
		"the scale is not between 1/65000 and 65000",
		"position_tolerance is not 1e-06 to 1000000 meters",
		"rotation_tolerance is not 1.7e-05 to 180 degrees",
		"the packet is of another format version",
		"the packet's header has positions out of range",
		"the packet is truncated in its header",
		"the packet's header has a grid step that is not positive",
		"the packet's header has a rotor size out of range",
		"the packet is too short for its number of bodies",
		"the body has a position that is not finite",
		"the packet is truncated",
		"the body has an id out of range",
		"the body has a rotor that is not of unit length",
		"the body has a scale out of range",
		"the packet has bytes after its last body",
	};
	static_assert(POSITION_TOLERANCE_RANGE.min == 1e-6 && POSITION_TOLERANCE_RANGE.max == 1e6 && CODEC_ROTATION_TOLERANCE_RANGE.min == 1.7e-5 && CODEC_ROTATION_TOLERANCE_RANGE.max == 180.0);
	static_assert(std::size(DESCRIPTIONS) == size_t(CodecFault::TRAILING_BYTES) + 1);
	return DESCRIPTIONS[size_t(fault)];
}

CodecResult encode(const BodyPose *bodies, size_t count, const Tolerance &tolerance, std::vector<uint8_t> &packet) {
	packet.clear();
	if (!POSITION_TOLERANCE_RANGE.contains(tolerance.position)) {
		return CodecError{ CodecFault::POSITION_TOLERANCE_OUT_OF_RANGE, 0 };
	}
	if (!CODEC_ROTATION_TOLERANCE_RANGE.contains(tolerance.rotation)) {
		return CodecError{ CodecFault::ROTATION_TOLERANCE_OUT_OF_RANGE, 0 };
	}
	const float step = position_step(tolerance.position);
	for (size_t i = 0; i < count; ++i) {
		if (const auto fault = find_fault(bodies[i], step)) {
			return CodecError{ *fault, i };
		}
	}
	const Grid grid = enclosing_grid(bodies, count, tolerance);
	BitWriter writer(packet);
	write_header(writer, grid, count);
	int64_t previous_id = -1;
	for (size_t i = 0; i < count; ++i) {
		write_body(writer, grid, bodies[i], previous_id);
		previous_id = bodies[i].id;
	}
	writer.flush();
	return {};
}

CodecResult decode(const uint8_t *packet, size_t size, std::vector<BodyPose> &bodies) {
	bodies.clear();
	BitReader reader(packet, size);
	Grid grid;
	size_t count = 0;
	if (const auto fault = read_header(reader, grid, count)) {
		return CodecError{ *fault, 0 };
	}
	bodies.resize(count);
	int64_t previous_id = -1;
	for (size_t i = 0; i < count; ++i) {
		if (const auto fault = read_body(reader, grid, previous_id, bodies[i])) {
			bodies.clear();
			return CodecError{ *fault, i };
		}
		previous_id = bodies[i].id;
	}
	if (!reader.at_end()) {
		bodies.clear();
		return CodecError{ CodecFault::TRAILING_BYTES, count };
	}
	return {};
}

} // namespace net
