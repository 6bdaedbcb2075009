#pragma once

#include "../../../harness/link_model.hpp"

#include "cga/motor/interpolate.hpp"

#include <string>

namespace bench {

/// The command line options, in SI units; tools/bench converts to them.
struct Options {
	std::string trace; ///< path; empty: measure the server load instead
	bool baselines = true; ///< whether to measure the other methods too
	harness::LinkSettings link; ///< each way
	double tolerance = 0.005; ///< meters
	double max_latency = 0.2; ///< seconds
	double send_rate = 20.0; ///< windows per second
	cga::Mode mode = cga::Mode::SEPARATE;
	uint64_t seed = 1;
	uint64_t runs = 1; ///< over the link, with consecutive seeds from `seed`; their errors are pooled
};

/// Parses arguments of the form --name=value. Returns an error; empty on success.
[[nodiscard]] std::string parse_options(int count, const char *const *arguments, Options &options);

} // namespace bench
