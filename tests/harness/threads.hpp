#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <type_traits>
#include <vector>

namespace harness {

/// Calls work(i), for i from 0 to `count` - 1, in a thread each, all at the same time. Returns the results by i. Work does not
/// use doctest's assertions, so that the thread sanitizer sees only the tested code.
template <class Work>
auto run_in_threads(size_t count, const Work &work) {
	using Result = decltype(work(size_t(0)));
	static_assert(!std::is_same_v<Result, bool>, "Threads cannot write elements of a std::vector<bool>.");
	std::vector<Result> results(count);
	std::atomic<size_t> ready = 0;
	std::vector<std::thread> threads;
	threads.reserve(count);
	for (size_t i = 0; i < count; ++i) {
		threads.emplace_back([&, i] {
			++ready;
			while (ready < count) {
				std::this_thread::yield();
			}
			results[i] = work(i);
		});
	}
	for (std::thread &thread : threads) {
		thread.join();
	}
	return results;
}

} // namespace harness
