#include "net/stream/snapshot_header.hpp"

#include <cmath>
#include <cstring>

namespace net {

namespace {

template <class Number>
void put_number(std::vector<uint8_t> &bytes, Number number) {
	uint64_t bits = 0;
	std::memcpy(&bits, &number, sizeof(number));
	for (size_t i = 0; i < sizeof(number); ++i) {
		bytes.push_back(uint8_t(bits >> (8 * i)));
	}
}

template <class Number>
Number read_number(const uint8_t *&bytes) {
	uint64_t bits = 0;
	for (size_t i = 0; i < sizeof(Number); ++i) {
		bits |= uint64_t(*bytes++) << (8 * i);
	}
	Number number;
	std::memcpy(&number, &bits, sizeof(number));
	return number;
}

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

PacketResult read_snapshot_header(const uint8_t *bytes, size_t size, SnapshotHeader &header) {
	static_assert(sizeof(uint32_t) == 4 && sizeof(float) == 4 && sizeof(double) == 8, "The wire format has these sizes.");
	if (size < SnapshotHeader::BYTES) {
		return PacketError::TRUNCATED_SNAPSHOT;
	}
	if (bytes[0] != STREAM_VERSION) {
		return PacketError::OTHER_STREAM_VERSION;
	}
	if (bytes[1] > uint8_t(cga::Mode::SEPARATE)) {
		return PacketError::UNKNOWN_MODE;
	}
	header.settings.mode = cga::Mode(bytes[1]);
	bytes += 2;
	header.settings.position_tolerance = double(read_number<float>(bytes));
	header.settings.rotation_tolerance = double(read_number<float>(bytes));
	header.settings.max_latency = double(read_number<float>(bytes));
	header.window = read_number<float>(bytes);
	header.settings.tick = read_number<double>(bytes);
	header.tick = read_number<uint32_t>(bytes);
	const bool is_valid = is_between(header.settings.position_tolerance, 1e-6, 1e6) && is_between(header.settings.rotation_tolerance, 1e-4, 180.0) &&
			is_between(header.settings.max_latency, 0.0, 60.0) && is_between(double(header.window), 0.0, 60.0) && is_between(header.settings.tick, 1e-4, 10.0);
	if (!is_valid) {
		return PacketError::SETTINGS_OUT_OF_RANGE;
	}
	return {};
}

} // namespace net
