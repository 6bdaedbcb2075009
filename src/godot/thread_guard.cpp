#include "godot/thread_guard.hpp"

namespace ga_godot {

using godot::Node;

static const void *main_thread = nullptr;

void remember_main_thread() {
	main_thread = current_thread();
}

bool is_main_thread() {
	return current_thread() == main_thread;
}

const Node *find_sub_thread_group(const Node *node) {
	while (node != nullptr && node->get_process_thread_group() == Node::PROCESS_THREAD_GROUP_INHERIT) {
		node = node->get_parent();
	}
	return node != nullptr && node->get_process_thread_group() == Node::PROCESS_THREAD_GROUP_SUB_THREAD ? node : nullptr;
}

} // namespace ga_godot
