#include "godot/thread_guard.hpp"

namespace ga_godot {

static const void *main_thread = nullptr;

void remember_main_thread() {
	main_thread = current_thread();
}

bool is_main_thread() {
	return current_thread() == main_thread;
}

} // namespace ga_godot
