#pragma once

#include "../../../harness/link_model.hpp"

#include "cga/motor/interpolate.hpp"

#include <string>

namespace bench {

/// What the program was asked for. tools/bench turns people's units into these.
struct Options {
	std::string trace; ///< file; empty: the load of a server instead
	bool baselines = true; ///< whether other methods are measured too
	harness::LinkSettings link; ///< each way
	double tolerance = 0.005; ///< metres
	double max_latency = 0.2; ///< seconds
	cga::Mode mode = cga::Mode::SEPARATE;
	uint64_t seed = 1;
	uint64_t runs = 1; ///< over the link, with seeds from `seed` on; their errors are taken together
};

/// Reads arguments --name=value. Empty, or what is wrong with them.
[[nodiscard]] std::string parse_options(int count, const char *const *arguments, Options &options);

} // namespace bench
