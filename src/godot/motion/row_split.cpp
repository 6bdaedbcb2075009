#include "godot/motion/row_split.hpp"

#include <godot_cpp/classes/os.hpp>
#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <algorithm>

namespace ga_godot {

using godot::OS;
using godot::WorkerThreadPool;

static uint32_t processor_count() {
	static const uint32_t COUNT = uint32_t(std::max(OS::get_singleton()->get_processor_count(), 1));
	return COUNT;
}

/// Godot 4.4 does not report the task of the calling thread.
static bool engine_knows_caller() {
	static const bool KNOWS = WorkerThreadPool::get_singleton()->has_method("get_caller_group_id");
	return KNOWS;
}

bool RowSplit::can_share() {
	if (processor_count() < 2) {
		return false;
	}
	if (!engine_knows_caller()) {
		// Tasks run in other threads than the main one.
		return OS::get_singleton()->get_thread_caller_id() == OS::get_singleton()->get_main_thread_id();
	}
	const WorkerThreadPool *pool = WorkerThreadPool::get_singleton();
	return pool->get_caller_task_id() == WorkerThreadPool::INVALID_TASK_ID && pool->get_caller_group_id() == WorkerThreadPool::INVALID_TASK_ID;
}

void RowSplit::share() {
	const uint32_t pieces = (_rows + ROWS_PER_PIECE - 1) / ROWS_PER_PIECE;
	const int others = int(std::min(processor_count(), pieces)) - 1;
	if (others < 1) {
		take_pieces();
		return;
	}
	WorkerThreadPool *pool = WorkerThreadPool::get_singleton();
	const auto task = [](void *split, uint32_t) { static_cast<RowSplit *>(split)->take_pieces(); };
	const WorkerThreadPool::GroupID group = pool->add_native_group_task(task, this, others, others, true);
	take_pieces();
	pool->wait_for_group_task_completion(group);
}

void RowSplit::take_pieces() {
	for (;;) {
		const uint32_t first = _next.fetch_add(ROWS_PER_PIECE, std::memory_order_relaxed);
		if (first >= _rows) {
			return;
		}
		_call(_job, first, std::min(ROWS_PER_PIECE, _rows - first));
	}
}

} // namespace ga_godot
