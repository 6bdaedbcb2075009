#pragma once

#include <atomic>
#include <cstdint>

namespace ga_godot {

/// Runs a job on many rows, split between the calling thread and the engine's WorkerThreadPool. Each free thread takes
/// the next piece, so a busy thread does not delay the others. A row's result must not depend on its piece.
class RowSplit {
public:
	/// Pieces begin at multiples of this.
	static constexpr uint32_t ROWS_PER_PIECE = 2048;

	/// Calls job(first, count) until all rows are done; in several threads if there are at least min_shared rows.
	template <class Job>
	static void run(uint32_t rows, uint32_t min_shared, const Job &job) {
		if (rows < min_shared || !can_share()) {
			job(0u, rows);
			return;
		}
		RowSplit split(rows, &job, [](const void *shared, uint32_t first, uint32_t count) {
			(*static_cast<const Job *>(shared))(first, count);
		});
		split.share();
	}

private:
	using Call = void (*)(const void *job, uint32_t first, uint32_t count);

	RowSplit(uint32_t rows, const void *job, Call call) :
			_rows(rows), _job(job), _call(call) {}

	/// False on a single processor, and within a task of the pool, where waiting for other tasks could deadlock; in Godot
	/// 4.4 also in every other thread than the main one.
	static bool can_share();
	void share();
	void take_pieces();

	uint32_t _rows;
	const void *_job;
	Call _call;
	std::atomic<uint32_t> _next = 0;
};

} // namespace ga_godot
