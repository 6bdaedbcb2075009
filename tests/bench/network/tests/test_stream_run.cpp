#include "../stream_run.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace bench;

namespace {

// A trace of oscillating bodies, optionally with a gap in the middle, as text.
std::string oscillating(int bodies, double rate, double seconds, double gap = 0.0) {
	std::string text;
	char line[200];
	for (int frame = 0; frame <= int(seconds * rate); ++frame) {
		const double t = 2.0 + frame / rate;
		if (std::abs(t - 2.0 - seconds / 2.0) < gap / 2.0) {
			continue;
		}
		for (int body = 0; body < bodies; ++body) {
			const double phase = 1.7 * t + body;
			std::snprintf(line, sizeof line, "%.6f,%d,%.6f,%.6f,%d,%.8f,0,%.8f,0\n", t, 3 * body, std::sin(phase), 0.3 * std::cos(2.3 * phase), body, std::cos(0.4 * phase), std::sin(0.4 * phase));
			text += line;
		}
	}
	return text;
}

// A trace of bodies that swing at up to 6 m/s and 12 rad/s from the first sample on, with times rounded to 0.1 ms.
std::string fast_clip(int bodies, double rate, double seconds) {
	std::string text;
	char line[200];
	for (int frame = 0; frame <= int(seconds * rate); ++frame) {
		const double t = frame / rate;
		for (int body = 0; body < bodies; ++body) {
			const double phase = 7.0 * t + body;
			const double angle = 0.8 * std::sin(1.1 * phase + 1.0);
			std::snprintf(line, sizeof line, "%.4f,%d,%.5f,%.5f,%.5f,%.6f,0,%.6f,0\n", t, body, 0.8 * std::sin(phase), 0.3 * std::cos(1.3 * phase), 0.1 * body, std::cos(angle), std::sin(angle));
			text += line;
		}
	}
	return text;
}

StreamResult run(const std::string &text, const harness::LinkSettings &link = {}, uint64_t seed = 1) {
	Trace trace;
	REQUIRE(parse_trace(text, "trace", trace) == "");
	const net::StreamSettings settings = stream_settings(trace, 0.005);
	return run_stream(trace, SourceFeed(trace, settings.tick, 2.0), settings, link, seed);
}

} // namespace

TEST_CASE("stream run: settings follow the trace and the tolerance") {
	Trace trace;
	REQUIRE(parse_trace(oscillating(1, 30.0, 1.0), "trace", trace) == "");
	CHECK(stream_settings(trace, 0.005).tick == doctest::Approx(1.0 / 30.0).epsilon(1e-4));
	CHECK(stream_settings(trace, 0.005).rotation_tolerance == doctest::Approx(1.4035).epsilon(1e-4));
	REQUIRE(parse_trace(oscillating(1, 1000.0, 1.0), "trace", trace) == "");
	CHECK(stream_settings(trace, 0.002).tick == 1.0 / 240.0);
	CHECK(stream_settings(trace, 0.002).position_tolerance == 0.002);
}

TEST_CASE("stream run: over an ideal link shown poses are within the tolerance, at every rate") {
	for (const double rate : { 20.0, 30.0, 60.0, 150.0 }) {
		const StreamResult result = run(oscillating(3, rate, 6.0));
		CHECK(result.problem == "");
		CHECK(result.rejected == 0);
		CHECK(result.method.errors.figures().p99 < 0.00501);
		CHECK(result.method.errors.figures().p99 > 0.0005);
		CHECK(result.method.delay_max < 0.2501);
		CHECK(result.method.delay_median > 0.01);
		// Only the beginning, before playback.
		CHECK(double(result.method.unseen) < 0.4 * rate * 3);
		CHECK(result.method.bytes_per_second > 10.0);
		CHECK(result.method.bytes_per_second < 3 * 400.0);
	}
}

TEST_CASE("stream run: a short fast clip is within the tolerance from its first sample on, at every rate, with rounded times") {
	for (const double rate : { 24.0, 30.0, 59.94, 100.0, 120.0 }) {
		const StreamResult result = run(fast_clip(6, rate, 2.3));
		CAPTURE(rate);
		CHECK(result.problem == "");
		CHECK(result.method.unseen == 0);
		CHECK(result.method.errors.figures().p99 < 0.00501);
		CHECK(result.method.errors.figures().max < 0.0055);
	}
}

TEST_CASE("stream run: the same seed gives the same run, another seed a different one") {
	harness::LinkSettings lossy;
	lossy.loss = 0.1;
	lossy.jitter = 0.03;
	lossy.delay = 0.02;
	const std::string text = oscillating(3, 60.0, 6.0);
	const StreamResult one = run(text, lossy, 5);
	const StreamResult same = run(text, lossy, 5);
	const StreamResult other = run(text, lossy, 6);
	CHECK(one.problem == "");
	CHECK(one.bytes_sent == same.bytes_sent);
	CHECK(one.method.errors.figures().max == same.method.errors.figures().max);
	CHECK(one.method.delay_max == same.method.delay_max);
	CHECK(one.bytes_sent != other.bytes_sent);
}

TEST_CASE("stream run: a gap in the trace, and bodies that appear and vanish") {
	const StreamResult result = run(oscillating(2, 60.0, 8.0, 3.0));
	CHECK(result.problem == "");
	CHECK(result.method.errors.figures().p50 < 0.005);
	CHECK(double(result.method.unseen) < 60.0);

	Trace trace;
	std::string text = oscillating(1, 60.0, 6.0);
	std::string late;
	for (size_t at = 0, end = 0; at < text.size(); at = end) {
		end = text.find('\n', at) + 1;
		const std::string line = text.substr(at, end - at);
		late += line;
		const double t = std::stod(line);
		if (t > 3.5 && t < 5.0) {
			late += line.substr(0, line.find(',')) + ",900" + line.substr(line.find(',', line.find(',') + 1));
		}
	}
	const StreamResult coming = run(late);
	CHECK(coming.problem == "");
	CHECK(coming.rejected == 0);
	CHECK(coming.method.errors.figures().p99 < 0.00501);
	CHECK(double(coming.method.unseen) < 30.0);
}

TEST_CASE("stream run: nothing is shown over a link that loses everything") {
	harness::LinkSettings dead;
	dead.loss = 1.0;
	const StreamResult result = run(oscillating(1, 60.0, 2.0), dead);
	CHECK(result.method.unseen == 121);
	CHECK(std::isnan(result.method.errors.figures().p99));
}
