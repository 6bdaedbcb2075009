#include "net/stream/snapshot_header.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <optional>

using namespace net;

namespace {

using Bytes = std::vector<uint8_t>;

SnapshotHeader valid_header() {
	SnapshotHeader header;
	header.settings.position_tolerance = 0.0025;
	header.settings.rotation_tolerance = 0.75;
	header.settings.max_latency = 0.15;
	header.settings.mode = cga::Mode::SCREW;
	header.settings.tick = 1.0 / 72.0;
	header.tick = 4000000000u;
	header.window = 0.125f;
	return header;
}

std::optional<PacketError> error_of(const Bytes &bytes) {
	const auto header = read_snapshot_header(bytes.data(), bytes.size());
	return header ? std::nullopt : std::optional<PacketError>(header.error());
}

std::optional<PacketError> error_of(const SnapshotHeader &header) {
	Bytes bytes;
	put_snapshot_header(bytes, header);
	return error_of(bytes);
}

} // namespace

TEST_CASE("snapshot header: settings round-trip in MIN_BYTES bytes") {
	Bytes bytes;
	put_snapshot_header(bytes, valid_header());
	CHECK(bytes.size() == SnapshotHeader::MIN_BYTES);
	CHECK(valid_header().bytes() == SnapshotHeader::MIN_BYTES);
	const auto read = read_snapshot_header(bytes.data(), bytes.size());
	REQUIRE(read);
	const SnapshotHeader &header = *read;
	CHECK(float(header.settings.position_tolerance) == 0.0025f);
	CHECK(float(header.settings.rotation_tolerance) == 0.75f);
	CHECK(float(header.settings.max_latency) == 0.15f);
	CHECK(header.settings.mode == cga::Mode::SCREW);
	CHECK(header.settings.tick == 1.0 / 72.0); // exact: times are counted in ticks
	CHECK(header.tick == 4000000000u);
	CHECK(header.window == 0.125f);
	CHECK(header.settings.position_tolerance_2d == 0.5);
}

TEST_CASE("snapshot header: a tolerance of planar bodies that is not the default takes four bytes") {
	SnapshotHeader planar = valid_header();
	planar.settings.position_tolerance_2d = 0.3;
	Bytes bytes;
	put_snapshot_header(bytes, planar);
	CHECK(bytes.size() == SnapshotHeader::MAX_BYTES);
	const auto read = read_snapshot_header(bytes.data(), bytes.size());
	REQUIRE(read);
	CHECK(read->bytes() == SnapshotHeader::MAX_BYTES);
	CHECK(read->tick == 4000000000u);
	CHECK(read->settings.mode == cga::Mode::SCREW);
	CHECK(float(read->settings.position_tolerance_2d) == 0.3f);
	// Both ends convert pixels to meters in the same way.
	CHECK(read->settings.planar_unit() == planar.settings.planar_unit());
	CHECK(planar.settings.planar_unit() == doctest::Approx(0.0025 / 0.3));
	for (size_t size = 0; size < bytes.size(); ++size) {
		CHECK(error_of(Bytes(bytes.begin(), bytes.begin() + ptrdiff_t(size))) == PacketError::TRUNCATED_SNAPSHOT);
	}
	// The default must not be sent.
	const float tolerance = 0.5f;
	std::memcpy(bytes.data() + SnapshotHeader::MIN_BYTES, &tolerance, sizeof(tolerance));
	CHECK(error_of(bytes) == PacketError::SETTINGS_OUT_OF_RANGE);
}

TEST_CASE("snapshot header: truncated, of another version or with values out of range, it is rejected") {
	Bytes bytes;
	put_snapshot_header(bytes, valid_header());
	for (size_t size = 0; size < bytes.size(); ++size) {
		CHECK(error_of(Bytes(bytes.begin(), bytes.begin() + ptrdiff_t(size))) == PacketError::TRUNCATED_SNAPSHOT);
	}
	Bytes other = bytes;
	++other[0];
	CHECK(error_of(other) == PacketError::OTHER_STREAM_VERSION);
	other = bytes;
	other[1] = 3;
	CHECK(error_of(other) == PacketError::UNKNOWN_MODE);

	const double nan = std::numeric_limits<double>::quiet_NaN();
	for (const double bad : { nan, -1.0, 1e30, std::numeric_limits<double>::infinity() }) {
		SnapshotHeader header = valid_header();
		header.settings.position_tolerance = bad;
		CHECK(error_of(header) == PacketError::SETTINGS_OUT_OF_RANGE);
		header = valid_header();
		header.settings.position_tolerance_2d = bad;
		CHECK(error_of(header) == PacketError::SETTINGS_OUT_OF_RANGE);
		header = valid_header();
		header.settings.rotation_tolerance = bad;
		CHECK(error_of(header) == PacketError::SETTINGS_OUT_OF_RANGE);
		header = valid_header();
		header.settings.max_latency = bad;
		CHECK(error_of(header) == PacketError::SETTINGS_OUT_OF_RANGE);
		header = valid_header();
		header.settings.tick = bad;
		CHECK(error_of(header) == PacketError::SETTINGS_OUT_OF_RANGE);
		header = valid_header();
		header.window = float(bad);
		CHECK(error_of(header) == PacketError::SETTINGS_OUT_OF_RANGE);
	}
	for (double StreamSettings::*member : { &StreamSettings::position_tolerance, &StreamSettings::position_tolerance_2d, &StreamSettings::rotation_tolerance, &StreamSettings::tick }) {
		SnapshotHeader header = valid_header();
		header.settings.*member = 0.0;
		CHECK(error_of(header) == PacketError::SETTINGS_OUT_OF_RANGE);
	}
	CHECK(error_of(valid_header()) == std::nullopt);
}
