#pragma once

#include <godot_cpp/classes/node.hpp>

#include <atomic>

namespace ga_godot {

/// Keeps nodes alive while their code is on the stack: callbacks of the engine and handlers of signals may call free().
///
/// Open a Scope around code that calls into the engine, and call before_free() in NOTIFICATION_PREDELETE. While a scope is open,
/// free() removes the node from the tree, but the engine frees it at the end of the frame, as queue_free() does.
class FreeGuard {
public:
	class Scope {
	public:
		explicit Scope(FreeGuard &guard) :
				_guard(guard) {
			_guard._depth++;
		}
		~Scope() { _guard._depth--; }
		Scope(const Scope &) = delete;
		Scope &operator=(const Scope &) = delete;

	private:
		FreeGuard &_guard;
	};

	void before_free(godot::Node &node) const {
		if (_depth > 0) {
			node.cancel_free();
			node.queue_free();
		}
	}

private:
	std::atomic<int> _depth = 0;
};

} // namespace ga_godot
