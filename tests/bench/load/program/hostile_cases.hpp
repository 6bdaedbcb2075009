#pragma once

#include <string>
#include <vector>

namespace bench {

/// Names of the cases with a hostile peer.
[[nodiscard]] std::vector<std::string> hostile_case_names();
/// Runs such a case and prints its rows. Returns false if there is none of this name. `is_quick`: shorter.
bool run_hostile_case(const std::string &name, bool is_quick);

} // namespace bench
