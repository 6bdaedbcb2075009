#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

// Stands in for the engine in tests/threads: runs group tasks in threads of the standard library, whose synchronization the
// thread sanitizer knows. (It does not see that of the engine, which is compiled without it.)

namespace godot {

class WorkerThreadPool {
public:
	using TaskID = int64_t;
	using GroupID = int64_t;
	static constexpr int64_t INVALID_TASK_ID = -1;

	static WorkerThreadPool *get_singleton() {
		static WorkerThreadPool pool;
		return &pool;
	}

	[[nodiscard]] bool has_method(const char *) const { return true; }
	[[nodiscard]] TaskID get_caller_task_id() const { return INVALID_TASK_ID; }
	[[nodiscard]] GroupID get_caller_group_id() const { return INVALID_TASK_ID; }

	GroupID add_native_group_task(void (*task)(void *, uint32_t), void *data, int elements, int /*tasks*/, bool /*high_priority*/) {
		std::vector<std::thread> threads;
		threads.reserve(size_t(elements));
		for (int element = 0; element < elements; ++element) {
			threads.emplace_back(task, data, uint32_t(element));
		}
		const std::lock_guard<std::mutex> lock(_mutex);
		_groups[++_last] = std::move(threads);
		return _last;
	}

	void wait_for_group_task_completion(GroupID group) {
		std::vector<std::thread> threads;
		{
			const std::lock_guard<std::mutex> lock(_mutex);
			threads = std::move(_groups[group]);
			_groups.erase(group);
		}
		for (std::thread &thread : threads) {
			thread.join();
		}
	}

private:
	std::mutex _mutex;
	std::map<GroupID, std::vector<std::thread>> _groups;
	GroupID _last = 0;
};

} // namespace godot
