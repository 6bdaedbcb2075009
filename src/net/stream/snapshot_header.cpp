#include "net/stream/snapshot_header.hpp"

#include "net/coding/byte_stream.hpp"

namespace net {

namespace {

bool is_between(double value, double min, double max) {
	return value >= min && value <= max;
}

} // namespace

void put_snapshot_header(std::vector<uint8_t> &bytes, const SnapshotHeader &header) {
	bytes.push_back(STREAM_VERSION);
	bytes.push_back(uint8_t(header.settings.mode));
	put_number(bytes, float(header.settings.position_tolerance));
	put_number(bytes, float(header.settings.rotation_tolerance));
	put_number(bytes, float(header.settings.max_latency));
	put_number(bytes, header.window);
	put_number(bytes, header.settings.tick);
	put_number(bytes, header.tick);
}

cga::Result<SnapshotHeader, PacketError> read_snapshot_header(const uint8_t *bytes, size_t size) {
	if (size < SnapshotHeader::BYTES) {
		return PacketError::TRUNCATED_SNAPSHOT;
	}
	if (bytes[0] != STREAM_VERSION) {
		return PacketError::OTHER_STREAM_VERSION;
	}
	if (bytes[1] > uint8_t(cga::Mode::SEPARATE)) {
		return PacketError::UNKNOWN_MODE;
	}
	ByteReader reader(bytes + 2, size - 2);
	SnapshotHeader header;
	header.settings.mode = cga::Mode(bytes[1]);
	header.settings.position_tolerance = double(reader.read<float>());
	header.settings.rotation_tolerance = double(reader.read<float>());
	header.settings.max_latency = double(reader.read<float>());
	header.window = reader.read<float>();
	header.settings.tick = reader.read<double>();
	header.tick = reader.read<uint32_t>();
	const bool is_valid = is_between(header.settings.position_tolerance, 1e-6, 1e6) && is_between(header.settings.rotation_tolerance, 1e-4, 180.0) &&
			is_between(header.settings.max_latency, 0.0, 60.0) && is_between(double(header.window), 0.0, 60.0) && is_between(header.settings.tick, 1e-4, 10.0);
	if (!is_valid) {
		return PacketError::SETTINGS_OUT_OF_RANGE;
	}
	return header;
}

} // namespace net
