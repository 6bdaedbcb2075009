#include "net/stream/snapshot_header.hpp"

#include "net/coding/byte_stream.hpp"

namespace net {

namespace {

constexpr uint8_t HAS_TOLERANCE_2D = 0x80; // in the byte of the mode

bool is_between(double value, double min, double max) {
	return value >= min && value <= max;
}

} // namespace

void put_snapshot_header(std::vector<uint8_t> &bytes, const SnapshotHeader &header) {
	bytes.push_back(STREAM_VERSION);
	bytes.push_back(uint8_t(uint8_t(header.settings.mode) | (header.has_tolerance_2d() ? HAS_TOLERANCE_2D : 0)));
	put_number(bytes, float(header.settings.position_tolerance));
	put_number(bytes, float(header.settings.rotation_tolerance));
	put_number(bytes, float(header.settings.max_latency));
	put_number(bytes, header.window);
	put_number(bytes, header.settings.tick);
	put_number(bytes, header.tick, SnapshotHeader::TICK_BYTES);
	if (header.has_tolerance_2d()) {
		put_number(bytes, float(header.settings.position_tolerance_2d));
	}
}

cga::Result<SnapshotHeader, PacketError> read_snapshot_header(const uint8_t *bytes, size_t size) {
	const bool has_tolerance_2d = size > 1 && (bytes[1] & HAS_TOLERANCE_2D) != 0;
	if (size < (has_tolerance_2d ? SnapshotHeader::MAX_BYTES : SnapshotHeader::MIN_BYTES)) {
		return PacketError::TRUNCATED_SNAPSHOT;
	}
	if (bytes[0] != STREAM_VERSION) {
		return PacketError::OTHER_STREAM_VERSION;
	}
	const auto mode = uint8_t(bytes[1] & ~HAS_TOLERANCE_2D);
	if (mode > uint8_t(cga::Mode::SEPARATE)) {
		return PacketError::UNKNOWN_MODE;
	}
	ByteReader reader(bytes + 2, size - 2);
	SnapshotHeader header;
	header.settings.mode = cga::Mode(mode);
	header.settings.position_tolerance = double(reader.read<float>());
	header.settings.rotation_tolerance = double(reader.read<float>());
	header.settings.max_latency = double(reader.read<float>());
	header.window = reader.read<float>();
	header.settings.tick = reader.read<double>();
	header.tick = reader.read<uint64_t>(SnapshotHeader::TICK_BYTES);
	if (has_tolerance_2d) {
		header.settings.position_tolerance_2d = double(reader.read<float>());
	}
	const bool is_valid = has_tolerance_2d == header.has_tolerance_2d() && is_between(header.settings.position_tolerance, 1e-6, 1e6) && is_between(header.settings.position_tolerance_2d, 1e-6, 1e6) && is_between(header.settings.rotation_tolerance, 1e-4, 180.0) &&
			is_between(header.settings.max_latency, 0.0, 60.0) && is_between(double(header.window), 0.0, 60.0) && is_between(header.settings.tick, 1e-4, 10.0);
	if (!is_valid) {
		return PacketError::SETTINGS_OUT_OF_RANGE;
	}
	return header;
}

} // namespace net
