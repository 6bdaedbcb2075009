#include "../load_cases.hpp"
#include "../load_run.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>

using namespace bench;

namespace {

// Per byte that the bodies cost on a clean line.
constexpr double MAX_CLEAN_RATIO = 1.5;
constexpr double MAX_ERROR_P99 = 0.010; // meters
constexpr double MAX_BURST = 4000.0; // bytes in one tick above the mean per tick
constexpr double MAX_STALL = 0.1; // seconds
constexpr double MAX_JOIN_RATIO = 1.6; // while what has accumulated during the join is sent: on long lines a join takes seconds
constexpr double MAX_LINE_RATIO = 2.0; // of what a narrow line carries, as its limit is found by exceeding it
constexpr double MAX_OTHERS_RATIO = 1.05; // of the bytes of receivers beside a bad one

LoadCase find_case(const std::string &name) {
	const std::vector<LoadCase> cases = load_cases(true);
	const auto found = std::find_if(cases.begin(), cases.end(), [&](const LoadCase &tried) { return tried.scenario.name == name; });
	REQUIRE(found != cases.end());
	return *found;
}

LoadResult run_case(const std::string &name);

// The bytes per second that the case's bodies cost on a clean line.
double need_of(const LoadCase &compared) {
	static std::map<std::string, double> per_body;
	const auto found = per_body.find(compared.base);
	const double cost = found != per_body.end() ? found->second : run_case(compared.base).groups[0].bytes_per_second / double(find_case(compared.base).scenario.bodies);
	per_body[compared.base] = cost;
	return cost * double(compared.scenario.bodies);
}

LoadResult run_case(const std::string &name) {
	LoadCase chosen = find_case(name);
	if (!chosen.rate_shares.empty()) {
		set_rates(chosen, need_of(chosen));
	}
	LoadResult result = run_load(chosen.scenario);
	CHECK(!result.is_cut);
	CHECK(result.rejected == 0);
	return result;
}

} // namespace

// The sanitizers' builds are too slow for thousands of bodies.
#ifndef SANITIZED

TEST_CASE("load: thousands of bodies over long and lossy lines cost little more than over a clean one") {
	for (const std::string name : { "rtt500_10k", "loss5_10k", "loss10_5k" }) {
		CAPTURE(name);
		const LoadResult result = run_case(name);
		const GroupResult &group = result.groups[0];
		CHECK(group.bytes_per_second <= (name == "rtt500_10k" ? MAX_JOIN_RATIO : MAX_CLEAN_RATIO) * need_of(find_case(name)));
		CHECK(group.error_p99 <= MAX_ERROR_P99);
		CHECK(group.burst <= MAX_BURST);
		CHECK(group.longest_stall <= MAX_STALL);
	}
}

TEST_CASE("load: a line that carries less than the need is not flooded") {
	for (const std::string name : { "half_1k", "tenth_1k", "half_policed_1k" }) {
		CAPTURE(name);
		const LoadCase narrow = find_case(name);
		const double rate = narrow.rate_shares[0].bytes_per_second * need_of(narrow);
		const LoadResult result = run_case(name);
		const GroupResult &group = result.groups[0];
		CHECK(group.bytes_per_second > 0.0);
		CHECK(group.bytes_per_second <= MAX_LINE_RATIO * rate);
		CHECK(group.burst <= MAX_BURST);
	}
}

TEST_CASE("load: over a narrow line errors grow, not the queue") {
	struct Row {
		std::string name;
		double max_error_p99; // meters; the bodies move at 1.8 m/s
		double max_stall; // seconds
		double max_delay;
	};
	for (const Row &row : { Row{ "half_1k", 0.6, 0.15, 0.6 }, Row{ "half_long_queue_1k", 0.3, 0.2, 0.8 }, Row{ "half_policed_1k", 0.6, 0.25, 1.0 }, Row{ "rate100_10k", 1.0, 0.25, 0.7 } }) {
		CAPTURE(row.name);
		const GroupResult group = run_case(row.name).groups[0];
		CHECK(group.error_p99 <= row.max_error_p99);
		CHECK(group.longest_stall <= row.max_stall);
		CHECK(group.delay_max <= row.max_delay);
	}
}

TEST_CASE("load: a receiver with a bad line costs the others nothing") {
	const double clean = run_case("clean_64").groups[0].bytes_per_second;
	for (const std::string name : { "loss20_1_of_64", "tenth_1_of_64" }) {
		CAPTURE(name);
		const LoadResult result = run_case(name);
		CHECK(result.groups[0].bytes_per_second <= MAX_OTHERS_RATIO * clean);
		CHECK(result.groups[0].error_p99 <= MAX_ERROR_P99);
		CHECK(result.groups[0].longest_stall <= MAX_STALL);
	}
}

#endif
