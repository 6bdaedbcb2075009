#pragma once

#include <ctime>

namespace bench {

/// Processor time of this thread, in seconds.
[[nodiscard]] inline double cpu_seconds() {
	timespec time{};
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
	return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

} // namespace bench
