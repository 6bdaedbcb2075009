#include "net/stream/snapshot_header.hpp"

#include "net/coding/byte_stream.hpp"

namespace net {

namespace {

constexpr uint8_t HAS_TOLERANCE_2D = 0x80; // in the byte of the mode

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
	bool is_valid = true;
	const auto read_setting = [&](double &setting, const SettingRange &range) {
		const auto value = reader.read<float>();
		setting = double(value);
		is_valid = is_valid && range.contains(value);
	};
	header.settings.mode = cga::Mode(mode);
	read_setting(header.settings.position_tolerance, POSITION_TOLERANCE_RANGE);
	read_setting(header.settings.rotation_tolerance, ROTATION_TOLERANCE_RANGE);
	read_setting(header.settings.max_latency, MAX_LATENCY_RANGE);
	header.window = reader.read<float>();
	header.settings.tick = reader.read<double>();
	header.tick = reader.read<uint64_t>(SnapshotHeader::TICK_BYTES);
	if (has_tolerance_2d) {
		read_setting(header.settings.position_tolerance_2d, POSITION_TOLERANCE_2D_RANGE);
		is_valid = is_valid && header.has_tolerance_2d();
	}
	is_valid = is_valid && TICK_RANGE.contains(header.settings.tick) && header.window >= 0.0f && header.window <= float(MAX_LATENCY_RANGE.max) && header.settings.max_latency <= double(float(MAX_LATENCY_TICKS * header.settings.tick));
	if (!is_valid) {
		return PacketError::SETTINGS_OUT_OF_RANGE;
	}
	return header;
}

} // namespace net
