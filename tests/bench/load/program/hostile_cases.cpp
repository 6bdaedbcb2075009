#include "hostile_cases.hpp"

#include "../../json_rows.hpp"
#include "../hostile_run.hpp"

#include "net/stream/stream_settings.hpp"

#include <cstdio>

namespace bench {

namespace {

constexpr double MILLI = 1e3;
constexpr double NANO = 1e9;
const std::string ATTACK_PREFIX = "hostile_";

// Requests without acknowledgement.
struct AmplificationCase {
	const char *name;
	size_t bodies;
	size_t requests;
	double interval; // seconds
};
constexpr AmplificationCase AMPLIFICATIONS[] = {
	{ "amplification_1_open_1k", 1000, 1, 0.0 },
	{ "amplification_27_opens_1k", 1000, 27, 0.25 },
	{ "amplification_27_opens_10k", 10000, 27, 0.25 },
};

void print_phase(const std::string &subject, size_t bodies, const char *phase, const HostilePhase &measured) {
	const auto row = [&](const char *name, double value, const char *unit) { print_row("load", (std::string(name) + "_" + phase).c_str(), subject, bodies, value, unit); };
	row("server_frame", measured.frame * NANO, "ns");
	row("server_frame_max", measured.frame_max * NANO, "ns");
	row("server_memory", measured.memory, "B");
	row("honest_error_p99", measured.error_p99 * MILLI, "mm");
	row("honest_delay_median", measured.delay_median * MILLI, "ms");
	row("honest_longest_stall", measured.longest_stall * MILLI, "ms");
	row("honest_bytes_per_second", measured.client_bytes_per_second, "B/s");
	row("hostile_bytes_per_second", measured.hostile_bytes_per_second, "B/s");
}

void run_attack(const std::string &name, Attack attack, bool is_quick) {
	HostileScenario scenario;
	scenario.attack = attack;
	scenario.seconds = is_quick ? 2.0 : scenario.seconds;
	scenario.cpu_limit = is_quick ? 20.0 : scenario.cpu_limit;
	const HostileResult result = run_hostile(scenario);
	const auto row = [&](const char *row_name, double value, const char *unit) { print_row("load", row_name, name, scenario.bodies, value, unit); };
	print_phase(name, scenario.bodies, "before", result.before);
	print_phase(name, scenario.bodies, "during", result.during);
	row("simulated_seconds", result.seconds, "s");
	row("is_cut", result.is_cut ? 1.0 : 0.0, "");
	row("hostile_packets", double(result.packets), "packets");
	row("hostile_bytes", double(result.bytes), "B");
	row("hostile_rejected", double(result.rejected), "packets");
	row("hostile_packet_cost", (result.during.frame - result.before.frame) * NANO / (scenario.packets_per_second * net::StreamSettings().tick), "ns");
	row("server_frame_ratio", result.during.frame / result.before.frame, "");
	std::fflush(stdout);
}

} // namespace

std::vector<std::string> hostile_case_names() {
	std::vector<std::string> names;
	names.reserve(size_t(Attack::COUNT));
	for (size_t attack = 0; attack < size_t(Attack::COUNT); ++attack) {
		names.push_back(ATTACK_PREFIX + attack_name(Attack(attack)));
	}
	for (const AmplificationCase &listed : AMPLIFICATIONS) {
		names.emplace_back(listed.name);
	}
	return names;
}

bool run_hostile_case(const std::string &name, bool is_quick) {
	for (size_t attack = 0; attack < size_t(Attack::COUNT); ++attack) {
		if (name == ATTACK_PREFIX + attack_name(Attack(attack))) {
			run_attack(name, Attack(attack), is_quick);
			return true;
		}
	}
	for (const AmplificationCase &listed : AMPLIFICATIONS) {
		if (name == listed.name) {
			const Amplification result = measure_amplification(listed.bodies, listed.requests, listed.interval);
			print_row("load", "bytes_in", name, listed.bodies, double(result.bytes_in), "B");
			print_row("load", "bytes_out", name, listed.bodies, double(result.bytes_out), "B");
			print_row("load", "amplification", name, listed.bodies, result.ratio, "");
			std::fflush(stdout);
			return true;
		}
	}
	return false;
}

} // namespace bench
