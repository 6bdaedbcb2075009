#include "method_result.hpp"

#include <algorithm>

namespace bench {

MethodResult pool_runs(const std::vector<MethodResult> &runs) {
	MethodResult pooled;
	pooled.subject = runs.front().subject;
	size_t unseen = 0;
	for (const MethodResult &run : runs) {
		pooled.errors.add(run.errors);
		pooled.bytes_per_second += run.bytes_per_second / double(runs.size());
		pooled.packets_per_second += run.packets_per_second / double(runs.size());
		pooled.delay_median += run.delay_median / double(runs.size());
		pooled.delay_max = std::max(pooled.delay_max, run.delay_max);
		unseen += run.unseen;
	}
	pooled.unseen = unseen / runs.size();
	return pooled;
}

} // namespace bench
