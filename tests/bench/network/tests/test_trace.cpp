#include "../trace.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace bench;

namespace {

const std::string NAMES = "t,id,x,y,z,qw,qx,qy,qz\n";

// The error of a line, without file name and line number.
std::string problem_of(const std::string &line) {
	Trace trace;
	const std::string error = parse_trace(NAMES + "0,1,0,0,0,1,0,0,0\n" + line + "\n", "a.csv", trace);
	const std::string place = "a.csv:3: ";
	REQUIRE(error.substr(0, place.size()) == place);
	return error.substr(place.size());
}

} // namespace

TEST_CASE("trace: bodies in any order, late, ending early and with gaps") {
	Trace trace;
	REQUIRE(parse_trace(NAMES + "1.5,7,1,2,3,1,0,0,0\n1.5,2,0,0,0,0,1,0,0\n2,7,1,2,4,1,0,0,0\n2.25,0,5,5,5,0,0,0,-1\n3.5,7,1,2,6,1,0,0,0\n", "a.csv", trace).empty());
	REQUIRE(trace.bodies.size() == 3);
	CHECK(trace.bodies[0].id == 0);
	CHECK(trace.bodies[1].id == 2);
	CHECK(trace.bodies[2].id == 7);
	CHECK(trace.bodies[1].samples.size() == 1);
	REQUIRE(trace.bodies[2].samples.size() == 3);
	CHECK(trace.bodies[2].samples[1].time == 2.0);
	CHECK(trace.bodies[2].samples[1].pose.translation == glm::dvec3(1, 2, 4));
	CHECK(trace.bodies[0].samples[0].pose.rotation == glm::dquat(0, 0, 0, -1));
	REQUIRE(trace.frames.size() == 4);
	CHECK(trace.frames[0].end - trace.frames[0].begin == 2);
	CHECK(trace.sample(trace.order[trace.frames[2].begin]).time == 2.25);
	CHECK(trace.order[trace.frames[2].begin].body == 0);
	CHECK(trace.order[4].sample == 2);
	CHECK(trace.begin() == 1.5);
	CHECK(trace.duration() == 2.0);
	CHECK(trace.sample_interval() == 1.5); // the upper median of 0.5 and 1.5
}

TEST_CASE("trace: the sample interval is accurate although times are rounded, and gaps do not count") {
	std::string text;
	for (int i = 0; i < 300; ++i) {
		const int digits = 100000 + i * 10000 / 30 + (i > 200 ? 70000 : 0); // 0.0333, 0.0333, 0.0334 ...
		text += std::to_string(digits / 10000) + "." + std::to_string(digits % 10000 + 10000).substr(1) + ",1,0,0,0,1,0,0,0\n";
	}
	Trace trace;
	REQUIRE(parse_trace(text, "a.csv", trace) == "");
	CHECK(trace.sample_interval() == doctest::Approx(1.0 / 30.0).epsilon(1e-4));
	CHECK(trace.duration() > 16.0);
}

TEST_CASE("trace: quaternions are normalized; a header, a byte order mark, spaces and any line ends are accepted") {
	Trace trace;
	REQUIRE(parse_trace("\xef\xbb\xbf" + NAMES + "0, 0, 0,0,0, 0.7071,0.7071,0,0\r\n\r\n1,0,1e-3,-2.5,+0,1,0,0,0", "a.csv", trace) != "");
	REQUIRE(parse_trace("\xef\xbb\xbf" + NAMES + "0, 0, 0,0,0, 0.7071,0.7071,0,0\r\n\r\n1,0,1e-3,-2.5,0,1,0,0,0", "a.csv", trace).empty());
	CHECK(glm::length(trace.bodies[0].samples[0].pose.rotation) == doctest::Approx(1.0).epsilon(1e-15));
	CHECK(trace.bodies[0].samples[1].pose.translation == glm::dvec3(0.001, -2.5, 0.0));
	CHECK(parse_trace("0,0,0,0,0,1,0,0,0\n1,0,0,0,0,1,0,0,0\n", "a.csv", trace).empty());
}

TEST_CASE("trace: of several samples of a body at one time, the last counts") {
	Trace trace;
	REQUIRE(parse_trace("0,1,1,0,0,1,0,0,0\n0,2,0,0,0,1,0,0,0\n0,1,2,0,0,1,0,0,0\n1,1,3,0,0,1,0,0,0\n", "a.csv", trace).empty());
	REQUIRE(trace.bodies[0].samples.size() == 2);
	CHECK(trace.bodies[0].samples[0].pose.translation.x == 2.0);
	CHECK(trace.order.size() == 3);
	CHECK(trace.frames[0].end == 2);
}

TEST_CASE("trace: an error names the line and the invalid field") {
	CHECK(problem_of("1,1,0,0,0,1,0,0") == "ends before the field qz");
	CHECK(problem_of("1") == "ends before the field id");
	CHECK(problem_of("1,1,0,0,0,1,0,0,0,9") == "has more than 9 fields");
	CHECK(problem_of("1,1,nan,0,0,1,0,0,0") == "x is 'nan', not a finite number");
	CHECK(problem_of("1,1,0,inf,0,1,0,0,0") == "y is 'inf', not a finite number");
	CHECK(problem_of("1,1,0,0,1e999,1,0,0,0") == "z is '1e999', not a finite number");
	CHECK(problem_of("1,1,0,,0,1,0,0,0") == "y is '', not a finite number");
	CHECK(problem_of("1s,1,0,0,0,1,0,0,0") == "t is '1s', not a finite number");
	CHECK(problem_of("1,-1,0,0,0,1,0,0,0") == "id is '-1', not an integer from 0 to 2147483647");
	CHECK(problem_of("1,1.5,0,0,0,1,0,0,0") == "id is '1.5', not an integer from 0 to 2147483647");
	CHECK(problem_of("1,2147483648,0,0,0,1,0,0,0") == "id is '2147483648', not an integer from 0 to 2147483647");
	CHECK(problem_of("1,1,0,0,0,0,0,0,0") == "the quaternion's length is 0.000000, not 1");
	CHECK(problem_of("1,1,0,0,0,1e300,1e300,0,0") == "the quaternion's length is inf, not 1");
	CHECK(problem_of("-1,1,0,0,0,1,0,0,0") == "time decreases from 0.000000 to -1.000000; sort the lines by time");
	CHECK(problem_of(std::string("1,1,\x1b[2J") + std::string(100, 'a') + ",0,0,1,0,0,0") == "x is '?[2J" + std::string(36, 'a') + "...', not a finite number");
	CHECK(problem_of(std::string(3, '\0')) == "ends before the field id");
}

TEST_CASE("trace: files that are not traces") {
	Trace trace;
	CHECK(parse_trace("", "a.csv", trace) == "a.csv: no samples; expected lines of t,id,x,y,z,qw,qx,qy,qz");
	CHECK(parse_trace(NAMES, "a.csv", trace) == "a.csv: no samples; expected lines of t,id,x,y,z,qw,qx,qy,qz");
	CHECK(parse_trace("0,1,0,0,0,1,0,0,0\n0,2,0,0,0,1,0,0,0\n", "a.csv", trace).substr(0, 38) == "a.csv: all samples have the same time;");
	CHECK(read_trace("/no/such/file.csv", trace).substr(0, 40) == "/no/such/file.csv: cannot read the file:");
	CHECK(read_trace("/", trace).substr(0, 24) == "/: cannot read the file:");
}
