#pragma once

#include <atomic>
#include <cstdint>

namespace ga_godot {

/// Work on many rows, shared between the calling thread and the engine's WorkerThreadPool where there are enough of them.
/// Whoever is free takes the next piece, so that it does not matter which threads are busy with other things. A row's
/// result must not depend on the piece that it is in.
class RowSplit {
public:
	/// Pieces begin at multiples of this many rows: whole blocks.
	static constexpr uint32_t ROWS_PER_PIECE = 2048;

	/// Runs p_job(first, count) until every row is done; from p_least rows on in several threads.
	template <class Job>
	static void run(uint32_t p_rows, uint32_t p_least, const Job &p_job) {
		if (p_rows < p_least || !can_share()) {
			p_job(0u, p_rows);
			return;
		}
		RowSplit split(p_rows, &p_job, [](const void *p_shared, uint32_t p_first, uint32_t p_count) {
			(*static_cast<const Job *>(p_shared))(p_first, p_count);
		});
		split.share();
	}

private:
	using Call = void (*)(const void *p_job, uint32_t p_first, uint32_t p_count);

	RowSplit(uint32_t p_rows, const void *p_job, Call p_call) :
			_rows(p_rows), _job(p_job), _call(p_call) {}

	/// Not from within a task: one that waits for others could keep them from starting. Not with a single processor.
	static bool can_share();
	void share();
	void take_pieces();

	uint32_t _rows;
	const void *_job;
	Call _call;
	std::atomic<uint32_t> _next = 0;
};

} // namespace ga_godot
