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
};

} // namespace godot
