// Simulates senders and receivers of thousands of bodies over lines of many kinds, and prints cost and error as rows. Run by
// tools/bench.

#include "../../json_rows.hpp"
#include "../load_run.hpp"
#include "hostile_cases.hpp"
#include "options.hpp"

#include <cstdio>
#include <map>
#include <optional>

using namespace bench;

namespace {

constexpr double MILLI = 1e3;

int fail(const std::string &problem) {
	std::fflush(stdout);
	std::fprintf(stderr, "%s\n", problem.c_str());
	return 1;
}

void print_group(const LoadScenario &scenario, const LoadResult &result, const GroupResult &group, double need) {
	const std::string subject = scenario.groups.size() > 1 ? result.name + "/" + group.name : result.name;
	const auto row = [&](const char *name, double value, const char *unit) { print_row("load", name, subject, scenario.bodies, value, unit); };
	row("receivers", double(group.receivers), "receivers");
	row("simulated_seconds", result.seconds, "s");
	row("is_cut", result.is_cut ? 1.0 : 0.0, "");
	row("bytes_per_second", group.bytes_per_second, "B/s");
	row("clean_ratio", need > 0.0 ? group.bytes_per_second / need : 1.0, "");
	row("packets_per_second", group.packets_per_second, "1/s");
	row("ack_bytes_per_second", group.ack_bytes_per_second, "B/s");
	row("burst_max", group.burst, "B");
	row("burst_p999", group.burst_p999, "B");
	row("early_tick_max", group.early_burst, "B");
	row("error_p50", group.error_p50 * MILLI, "mm");
	row("error_p99", group.error_p99 * MILLI, "mm");
	row("error_max", group.error_max * MILLI, "mm");
	row("error_rest_max", group.resting_error_max * MILLI, "mm");
	row("unseen_share", group.unseen_share, "");
	row("frozen_share", group.frozen_share, "");
	row("longest_stall", group.longest_stall * MILLI, "ms");
	row("playback_delay_median", group.delay_median * MILLI, "ms");
	row("playback_delay", group.delay_max * MILLI, "ms");
	row("ready_after", group.ready_after * MILLI, "ms");
	row("snapshots", group.snapshots, "snapshots");
	row("retransmissions", group.retransmissions, "chunks");
	row("dropped", group.dropped, "datagrams");
	row("receiver_core_share", group.core_share, "cores");
	row("receiver_frame", group.frame_ns, "ns");
	row("receiver_memory", group.memory, "B");
	row("receiver_memory_growth", group.memory_growth, "B/min");
	row("receiver_rejected", double(group.rejected), "packets");
	row("sender_core_share", result.core_share, "cores");
	row("sender_tick", result.tick_ns, "ns");
	row("sender_tick_max", result.tick_ns_max, "ns");
	row("sender_memory", result.memory, "B");
	row("sender_memory_growth", result.memory_growth, "B/min");
	row("sender_rejected", double(result.rejected), "items");
	std::fflush(stdout);
}

/// Changes that a case on a clean line shares with the case that is compared with it.
LoadChanges without_line(const LoadChanges &changes) {
	LoadChanges kept;
	kept.bodies = changes.bodies;
	kept.moving_share = changes.moving_share;
	kept.seconds = changes.seconds;
	kept.warm_up = changes.warm_up;
	kept.tolerance = changes.tolerance;
	kept.max_latency = changes.max_latency;
	kept.send_rate = changes.send_rate;
	kept.cpu_limit = changes.cpu_limit;
	kept.seed = changes.seed;
	return kept;
}

class Program {
public:
	explicit Program(const LoadOptions &options) :
			_options(options), _cases(load_cases(options.is_quick)) {
		// What the options alone describe.
		LoadCase clean = _cases[*find("clean_1k")];
		clean.scenario.name = "clean";
		_cases.push_back(clean);
		clean.scenario.name = "custom";
		clean.base = "clean";
		_cases.push_back(clean);
	}

	int run() {
		std::vector<std::string> names = _options.cases;
		const bool is_custom = names.empty() && _options.has_changes;
		if (is_custom) {
			names = { "custom" };
		}
		for (size_t i = 0; names.empty() && i + 2 < _cases.size(); ++i) {
			run_case(i, _options.changes);
		}
		if (names.empty()) {
			names = hostile_case_names();
		}
		for (const std::string &name : names) {
			const std::optional<size_t> found = find(name);
			if (!found && run_hostile_case(name, _options.is_quick)) {
				continue;
			}
			if (!found) {
				return fail("'" + name + "' is not a case; the cases are " + list());
			}
			run_case(*found, _options.changes);
		}
		return 0;
	}

private:
	[[nodiscard]] std::optional<size_t> find(const std::string &name) const {
		for (size_t i = 0; i < _cases.size(); ++i) {
			if (_cases[i].scenario.name == name) {
				return i;
			}
		}
		return std::nullopt;
	}

	[[nodiscard]] std::string list() const {
		std::string names;
		for (const LoadCase &listed : _cases) {
			names += listed.scenario.name + ", ";
		}
		for (const std::string &name : hostile_case_names()) {
			names += name + (name == hostile_case_names().back() ? "" : ", ");
		}
		return names;
	}

	// Runs and prints a case, after the one it is compared with. Returns the bytes per second and body to a receiver. A case runs once.
	double run_case(size_t index, const LoadChanges &changes) {
		if (const auto done = _bytes.find(index); done != _bytes.end()) {
			return done->second;
		}
		LoadCase chosen = _cases[index];
		const std::optional<size_t> base = find(chosen.base);
		const double per_body = base ? run_case(*base, without_line(changes)) : 0.0;
		apply(changes, chosen);
		const double need = per_body * double(chosen.scenario.bodies);
		set_rates(chosen, need);
		const LoadResult result = run_load(chosen.scenario);
		for (const GroupResult &group : result.groups) {
			print_group(chosen.scenario, result, group, need);
		}
		return _bytes[index] = result.groups[0].bytes_per_second / double(chosen.scenario.bodies);
	}

	const LoadOptions &_options;
	std::vector<LoadCase> _cases;
	std::map<size_t, double> _bytes; // per second, body and receiver, by case
};

} // namespace

int main(int count, char **arguments) {
	LoadOptions options;
	const std::string problem = parse_options(count, arguments, options);
	return problem.empty() ? Program(options).run() : fail(problem);
}
