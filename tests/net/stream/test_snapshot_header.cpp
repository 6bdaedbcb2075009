#include "net/stream/snapshot_header.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace net;

namespace {

using Bytes = std::vector<uint8_t>;

SnapshotHeader sound() {
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

std::string problem(const Bytes &bytes) {
	SnapshotHeader header;
	const char *error = read_snapshot_header(bytes.data(), bytes.size(), header);
	return error != nullptr ? error : "";
}

std::string problem(const SnapshotHeader &header) {
	Bytes bytes;
	put_snapshot_header(bytes, header);
	return problem(bytes);
}

} // namespace

TEST_CASE("state header: settings come back in so many bytes") {
	Bytes bytes;
	put_snapshot_header(bytes, sound());
	CHECK(bytes.size() == SnapshotHeader::BYTES);
	SnapshotHeader header;
	REQUIRE(read_snapshot_header(bytes.data(), bytes.size(), header) == nullptr);
	CHECK(float(header.settings.position_tolerance) == 0.0025f);
	CHECK(float(header.settings.rotation_tolerance) == 0.75f);
	CHECK(float(header.settings.max_latency) == 0.15f);
	CHECK(header.settings.mode == cga::Mode::SCREW);
	CHECK(header.settings.tick == 1.0 / 72.0); // exactly: it is what times are counted in
	CHECK(header.tick == 4000000000u);
	CHECK(header.window == 0.125f);
}

TEST_CASE("state header: cut off, of another version, with what no sender says, it is refused") {
	Bytes bytes;
	put_snapshot_header(bytes, sound());
	for (size_t size = 0; size < bytes.size(); ++size) {
		CHECK(problem(Bytes(bytes.begin(), bytes.begin() + ptrdiff_t(size))) == "the state is cut off");
	}
	Bytes other = bytes;
	++other[0];
	CHECK(problem(other) == "the stream is of another version of the addon: update the older side");
	other = bytes;
	other[1] = 3;
	CHECK(problem(other) == "the state's mode is unknown");

	const double nan = std::numeric_limits<double>::quiet_NaN();
	for (const double bad : { nan, -1.0, 1e30, std::numeric_limits<double>::infinity() }) {
		const std::string refused = "the state's settings are out of range";
		SnapshotHeader header = sound();
		header.settings.position_tolerance = bad;
		CHECK(problem(header) == refused);
		header = sound();
		header.settings.rotation_tolerance = bad;
		CHECK(problem(header) == refused);
		header = sound();
		header.settings.max_latency = bad;
		CHECK(problem(header) == refused);
		header = sound();
		header.settings.tick = bad;
		CHECK(problem(header) == refused);
		header = sound();
		header.window = float(bad);
		CHECK(problem(header) == refused);
	}
	for (double StreamSettings::*member : { &StreamSettings::position_tolerance, &StreamSettings::rotation_tolerance, &StreamSettings::tick }) {
		SnapshotHeader header = sound();
		header.settings.*member = 0.0;
		CHECK(problem(header) == "the state's settings are out of range");
	}
	CHECK(problem(sound()) == "");
}
