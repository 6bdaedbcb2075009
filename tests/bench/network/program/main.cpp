// Replicates a trace over a simulated link with every method and prints cost and error as rows; without a trace, the load
// of a server with many receivers. Run by tools/bench.

#include "../../json_rows.hpp"
#include "../baseline.hpp"
#include "options.hpp"
#include "server_load.hpp"
#include "stream_timing.hpp"

#include <cstdio>

using namespace bench;

namespace {

// Seconds after the end of the trace for the receiver to play its last samples.
constexpr double DRAIN = 5.0;
constexpr const char *SUITE = "network";
constexpr double MILLI = 1e3;
constexpr double NANO = 1e9;

int fail(const std::string &problem) {
	std::fflush(stdout);
	std::fprintf(stderr, "%s\n", problem.c_str());
	return 1;
}

void print_method(const MethodResult &method, const Trace &trace) {
	const size_t bodies = trace.bodies.size();
	const ErrorFigures errors = method.errors.figures();
	const auto row = [&](const char *name, double value, const char *unit) { print_row(SUITE, name, method.subject, bodies, value, unit); };
	row("bytes_per_second_per_body", method.bytes_per_second / double(bodies), "B/s");
	row("packets_per_second", method.packets_per_second, "1/s");
	row("error_p50", errors.p50 * MILLI, "mm");
	row("error_p99", errors.p99 * MILLI, "mm");
	row("error_max", errors.max * MILLI, "mm");
	row("error_rest_p99", errors.rest_p99 * MILLI, "mm");
	row("error_rest_max", errors.rest_max * MILLI, "mm");
	row("samples_moving", double(errors.moving_count), "samples");
	row("samples_unseen", double(method.unseen), "samples");
	row("playback_delay", method.delay_max * MILLI, "ms");
	row("playback_delay_median", method.delay_median * MILLI, "ms");
}

// An error; empty on success.
std::string measure_ours(const Options &options, const Trace &trace) {
	net::StreamSettings settings = stream_settings(trace, options.tolerance);
	settings.max_latency = options.max_latency;
	settings.send_rate = options.send_rate;
	settings.mode = options.mode;
	const SourceFeed feed(trace, settings.tick, DRAIN);
	StreamResult first;
	std::vector<MethodResult> runs;
	runs.reserve(options.runs);
	double ack_bytes = 0.0;
	for (uint64_t run = 0; run < options.runs; ++run) {
		StreamResult stream = run_stream(trace, feed, settings, options.link, options.seed + run);
		if (!stream.problem.empty()) {
			return stream.problem;
		}
		if (stream.rejected > 0) {
			return "the sender rejected " + std::to_string(stream.rejected) + " poses, which are out of range";
		}
		ack_bytes += stream.ack_bytes_per_second / double(options.runs);
		runs.push_back(std::move(stream.method));
		if (run == 0) {
			first = std::move(stream);
		}
	}
	const MethodResult pooled = pool_runs(runs);
	print_method(pooled, trace);
	const auto row = [&](const char *name, double value, const char *unit) { print_row(SUITE, name, pooled.subject, trace.bodies.size(), value, unit); };
	row("ack_bytes_per_second_per_body", ack_bytes / double(trace.bodies.size()), "B/s");
	const StreamTiming timing = time_stream(trace, feed, settings, first);
	if (!timing.is_deterministic) {
		return "the sender sent a different number of bytes when it was run again";
	}
	row("encode", timing.encode * NANO, "ns/pose");
	row("decode", timing.decode * NANO, "ns/pose");
	row("allocations_per_packet", timing.sender_allocations + timing.receiver_allocations, "allocations");
	row("sender_allocations_per_packet", timing.sender_allocations, "allocations");
	row("receiver_allocations_per_packet", timing.receiver_allocations, "allocations");
	return {};
}

void measure_baseline(const Options &options, const Trace &trace, const Baseline &baseline) {
	std::vector<MethodResult> runs;
	runs.reserve(options.runs);
	for (uint64_t run = 0; run < options.runs; ++run) {
		runs.push_back(run_baseline(trace, baseline, options.link, options.seed + run));
	}
	print_method(pool_runs(runs), trace);
}

int measure_trace(const Options &options) {
	Trace trace;
	std::string problem = read_trace(options.trace, trace);
	if (!problem.empty()) {
		return fail(problem);
	}
	problem = measure_ours(options, trace);
	if (!problem.empty()) {
		return fail(options.trace + ": " + problem);
	}
	for (const Baseline &baseline : options.baselines ? baselines() : std::vector<Baseline>()) {
		measure_baseline(options, trace, baseline);
	}
	return 0;
}

int measure_server(const Options &options) {
	net::StreamSettings settings;
	settings.position_tolerance = options.tolerance;
	settings.mode = options.mode;
	// A longer latency would allow longer and fewer windows.
	settings.send_rate = 20.0;
	settings.max_latency = 1.0 / settings.send_rate;
	ServerLoadSettings load;
	load.link = options.link;
	const ServerLoad result = measure_server_load(load, settings, options.seed);
	if (!result.problem.empty()) {
		return fail("server load: " + result.problem);
	}
	const size_t poses = load.bodies * load.receivers;
	print_row(SUITE, "server_core_share", "ga_godot", poses, result.core_share, "cores");
	print_row(SUITE, "server_bytes_per_second_per_body", "ga_godot", poses, result.bytes_per_second / double(poses), "B/s");
	print_row(SUITE, "server_packets_per_second", "ga_godot", poses, result.packets_per_second, "1/s");
	return 0;
}

} // namespace

int main(int count, char **arguments) {
	Options options;
	const std::string problem = parse_options(count, arguments, options);
	if (!problem.empty()) {
		return fail(problem);
	}
	return options.trace.empty() ? measure_server(options) : measure_trace(options);
}
