#pragma once

#include "load_scenario.hpp"

#include <optional>

namespace bench {

/// A scenario, and with which other one to compare its bytes.
struct LoadCase {
	LoadScenario scenario;
	std::string base; ///< name of the case on a clean line, whose bytes per body are compared; empty: none
	/// Rates of all lines to the receivers as shares of what the base case sends; empty: LineSettings::rates applies.
	std::vector<LineRate> rate_shares;
	std::string rated_group; ///< the only group that rate_shares applies to; empty: all
};

/// What the command line changes in a case. Times in seconds, loss from 0 to 1.
struct LoadChanges {
	std::optional<double> bodies;
	std::optional<double> moving_share;
	std::optional<double> receivers; ///< of the first group
	std::optional<double> round_trip;
	std::optional<double> jitter;
	std::optional<double> loss;
	std::optional<double> ack_loss;
	std::optional<double> burst;
	std::optional<double> bytes_per_second;
	std::optional<double> queue;
	std::optional<double> polices;
	std::optional<double> seconds;
	std::optional<double> warm_up;
	std::optional<double> tolerance;
	std::optional<double> max_latency;
	std::optional<double> send_rate;
	std::optional<double> cpu_limit;
	std::optional<double> seed;
};

/// All cases. `is_quick`: with runs as short as a test needs.
[[nodiscard]] std::vector<LoadCase> load_cases(bool is_quick);
/// Changes the scenario of a case; line changes apply to every group.
void apply(const LoadChanges &changes, LoadCase &changed);
/// Sets the rates that are shares of the need: what the bodies cost on a clean line, in bytes per second.
void set_rates(LoadCase &changed, double need);

} // namespace bench
