#pragma once

// Stands in for the engine in tests/threads.

namespace godot {

class OS {
public:
	static OS *get_singleton() {
		static OS os;
		return &os;
	}

	[[nodiscard]] int get_processor_count() const { return 4; }
	[[nodiscard]] int get_thread_caller_id() const { return 1; }
	[[nodiscard]] int get_main_thread_id() const { return 1; }
};

} // namespace godot
